#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "draco/rans.h"

namespace dini {

/// How much is spent on a good table of probabilities, as in libdraco: 10 less the speed of the encoder; 7 is usual.
using TableEffort = int;
inline constexpr TableEffort usual_table_effort = 7;

/// How some symbols are written: each by its own probability, or, where they are many different ones, each as plain
/// bits whose number has a probability. Whichever is expected to be shorter (Draco bitstream 2.2, "Symbol Decoding").
class SymbolCoding {
 public:
  /// For at least one row.
  SymbolCoding(const SymbolRows& symbols, TableEffort effort);

  /// What the range coder has to write.
  RansInput input() const;

  /// Adds what decoders read: the scheme, the table, `coded` (the bytes of `input()`), and the plain bits.
  void write(const std::string& coded, ByteWriter& bytes) const;

 private:
  SymbolRows symbols_;
  std::vector<std::uint32_t> lengths_;  ///< bits of the largest value of each row; empty when values are coded directly
  int table_size_ = 0;                  ///< what is written for decoders to know the precision
  RansTable table_;

  struct Choice;
  SymbolCoding(const SymbolRows& symbols, Choice choice);
  static Choice choose(const SymbolRows& symbols, TableEffort effort);
};

/// Adds some symbols, or none at all when there are none.
void write_symbols(const SymbolRows& symbols, TableEffort effort, ByteWriter& bytes);

}  // namespace dini
