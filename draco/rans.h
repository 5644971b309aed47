#pragma once

// Range asymmetric numeral systems (Duda 2013) as in Draco streams: what is written first is read last.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "draco/byte_writer.h"

namespace dini {

/// What the coder needs to know of a symbol.
struct RansSymbol {
  std::uint32_t probability;  ///< share of the precision
  std::uint32_t cumulative;   ///< of all symbols before it
  std::uint32_t reciprocal;   ///< with `shift`, divides any state by `probability`
  std::uint32_t shift;
};

/// How often each symbol is expected, in whole shares of 2^bits.
class RansTable {
 public:
  /// Shares after the frequencies, at least 1 for a symbol that occurs, 2^bits in all; `bits` in 12..20. The last
  /// frequency is not 0, and fewer than 2^bits are. Shares are rounded; the most frequent symbols give what is too much
  /// or take what is missing.
  RansTable(std::span<const std::uint32_t> frequencies, int bits);

  int bits() const { return bits_; }
  /// Of a symbol that occurs.
  const RansSymbol& operator[](std::uint32_t symbol) const { return symbols_[symbol]; }
  /// Of each symbol, 0 for those that do not occur.
  std::span<const std::uint32_t> shares() const { return shares_; }

  /// The shares, as decoders read them.
  void write(ByteWriter& bytes) const;

 private:
  int bits_;
  std::vector<std::uint32_t> shares_;
  std::unique_ptr<RansSymbol[]> symbols_;  ///< written only where symbols occur
};

/// Small whole numbers in rows, as a stream holds them one after another.
struct SymbolRows {
  const std::uint32_t* values = nullptr;
  std::size_t count = 0;   ///< of rows
  int columns = 1;         ///< 1 to 4
  std::size_t stride = 1;  ///< from row to row

  const std::uint32_t* row(std::size_t index) const { return values + index * stride; }
  std::size_t size() const { return count * static_cast<std::size_t>(columns); }
};

/// Symbols to write with their table.
struct RansInput {
  const RansTable* table = nullptr;
  SymbolRows symbols;
};

/// The bytes of `input`, that decoders read from the end.
std::string rans_bytes(const RansInput& input);

/// The bytes of two inputs with as many rows, written side by side: each waits for its own state only.
struct TwoTexts {
  std::string first;
  std::string second;
};
TwoTexts rans_bytes(const RansInput& first, const RansInput& second);

/// Bits with one probability for all: that of zero in 256ths, then the coded bits as a block.
void write_bits(const std::vector<bool>& bits, ByteWriter& bytes);

}  // namespace dini
