#include "draco/symbol_coding.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "draco/bit_writer.h"
#include "draco/occurring.h"

namespace dini {
namespace {

constexpr int largest_table_size = 18;  // bits of the number of symbols that a decoder takes
constexpr std::size_t length_count = 33;
constexpr int length_table_bits = 12;

enum class Scheme : std::uint8_t { lengths = 0, values = 1 };

/// How often each number occurs, up to the largest that does.
using Frequencies = std::vector<std::uint32_t>;

std::uint32_t bit_length(std::uint32_t value) { return static_cast<std::uint32_t>(std::bit_width(value | 1)); }

/// How many different numbers there are, and bits that all take with ideal probabilities.
struct Information {
  std::size_t different = 0;
  std::int64_t bits = 0;
};

Information information(const Frequencies& frequencies, std::size_t count) {
  Information result;
  double bits = 0;
  const auto total = static_cast<double>(count);
  for_each_that_occurs(frequencies, [&](std::size_t, std::uint32_t frequency) {
    bits += frequency * std::log2(static_cast<double>(frequency) / total);
    ++result.different;
  });
  result.bits = static_cast<std::int64_t>(-bits);
  return result;
}

// Bits that the table takes, about: a byte for each symbol and each gap.
std::int64_t table_bits(std::size_t largest, std::size_t different) {
  const auto gaps = static_cast<std::int64_t>(different) +
                    (static_cast<std::int64_t>(largest) - static_cast<std::int64_t>(different)) / 64;
  return 8 * static_cast<std::int64_t>(different) + 8 * gaps;
}

int precision_bits(int table_size) { return std::clamp(3 * table_size / 2, 12, 20); }

int table_size_of(std::size_t different, TableEffort effort) {
  const int wish = effort < 4 ? -2 : effort < 6 ? -1 : effort > 9 ? 2 : effort > 7 ? 1 : 0;
  return std::clamp(static_cast<int>(std::bit_width(different)) + wish, 1, largest_table_size);
}

/// What choosing needs to know of symbols.
struct Counts {
  Frequencies values;   ///< empty when the symbols are too large to be coded directly
  Frequencies lengths;  ///< of the bits of the largest symbol of each row
  std::int64_t plain_bits = 0;
};

// All bits that occur in a row.
std::uint32_t bits_of(const std::uint32_t* row, int columns) {
  std::uint32_t bits = 0;
  for (int column = 0; column < columns; ++column) bits |= row[column];
  return bits;
}

// Equal neighbors are the rule, and each would wait for the one before: where there are many, every other row is
// counted apart.
template <int columns>
Counts counts_of(const SymbolRows& symbols) {
  std::uint32_t all = 0;
  for (std::size_t i = 0; i < symbols.count; ++i) all |= bits_of(symbols.row(i), columns);
  const bool directly = bit_length(all) <= largest_table_size;
  const std::size_t value_count = directly ? std::size_t{1} << bit_length(all) : 0;
  const std::size_t apart = symbols.size() > value_count ? 1 : 0;
  Frequencies lengths[2] = {Frequencies(length_count, 0), Frequencies(length_count, 0)};
  Frequencies values[2] = {Frequencies(value_count, 0), Frequencies(apart * value_count, 0)};
  for (std::size_t i = 0; i < symbols.count; ++i) {
    const std::uint32_t* const row = symbols.row(i);
    ++lengths[i & apart][bit_length(bits_of(row, columns))];
    if (!directly) continue;
    for (int column = 0; column < columns; ++column) ++values[i & apart][row[column]];
  }
  const auto sum = [](Frequencies& a, const Frequencies& b) {
    for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
    while (!a.empty() && a.back() == 0) a.pop_back();
    return std::move(a);
  };
  Counts counts;
  counts.values = sum(values[0], values[1]);
  counts.lengths = sum(lengths[0], lengths[1]);
  for (std::size_t length = 0; length < counts.lengths.size(); ++length) {
    counts.plain_bits += columns * static_cast<std::int64_t>(length) * counts.lengths[length];
  }
  return counts;
}

Counts counts_of(const SymbolRows& symbols) {
  switch (symbols.columns) {
    case 1:
      return counts_of<1>(symbols);
    case 2:
      return counts_of<2>(symbols);
    case 3:
      return counts_of<3>(symbols);
    default:
      return counts_of<4>(symbols);
  }
}

}  // namespace

struct SymbolCoding::Choice {
  std::vector<std::uint32_t> lengths;
  int table_size = 0;
  RansTable table;
};

SymbolCoding::Choice SymbolCoding::choose(const SymbolRows& symbols, TableEffort effort) {
  const Counts counts = counts_of(symbols);
  if (!counts.values.empty()) {
    const auto [different, bits] = information(counts.values, symbols.size());
    const auto [different_lengths, length_bits] = information(counts.lengths, symbols.count);
    const std::int64_t by_values = bits + table_bits(counts.values.size() - 1, different);
    const std::int64_t by_lengths = length_bits + table_bits(different_lengths, different_lengths) + counts.plain_bits;
    if (by_values <= by_lengths) {
      const int table_size = table_size_of(different, effort);
      return {{}, table_size, RansTable(counts.values, precision_bits(table_size))};
    }
  }
  std::vector<std::uint32_t> lengths(symbols.count);
  for (std::size_t row = 0; row < lengths.size(); ++row)
    lengths[row] = bit_length(bits_of(symbols.row(row), symbols.columns));
  return {std::move(lengths), 0, RansTable(counts.lengths, length_table_bits)};
}

SymbolCoding::SymbolCoding(const SymbolRows& symbols, TableEffort effort)
    : SymbolCoding(symbols, choose(symbols, effort)) {}

SymbolCoding::SymbolCoding(const SymbolRows& symbols, Choice choice)
    : symbols_(symbols),
      lengths_(std::move(choice.lengths)),
      table_size_(choice.table_size),
      table_(std::move(choice.table)) {}

RansInput SymbolCoding::input() const {
  if (lengths_.empty()) return {&table_, symbols_};
  return {&table_, {lengths_.data(), lengths_.size(), 1, 1}};
}

void SymbolCoding::write(const std::string& coded, ByteWriter& bytes) const {
  const bool directly = lengths_.empty();
  bytes.byte(static_cast<std::uint8_t>(directly ? Scheme::values : Scheme::lengths));
  if (directly) bytes.byte(static_cast<std::uint8_t>(table_size_));
  table_.write(bytes);
  bytes.block(coded);
  if (directly) return;
  BitWriter plain;
  for (std::size_t row = 0; row < symbols_.count; ++row) {
    for (int column = 0; column < symbols_.columns; ++column) {
      plain.bits(symbols_.row(row)[column], static_cast<int>(lengths_[row]));
    }
  }
  bytes.text(plain.take());
}

void write_symbols(const SymbolRows& symbols, TableEffort effort, ByteWriter& bytes) {
  if (symbols.count == 0) return;
  const SymbolCoding coding(symbols, effort);
  coding.write(rans_bytes(coding.input()), bytes);
}

}  // namespace dini
