#include "draco/symbol_coding.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "draco/bit_writer.h"

namespace dini {
namespace {

constexpr int largest_table_size = 18;  // bits of the number of symbols that a decoder takes
constexpr std::size_t length_count = 33;
constexpr int length_table_bits = 12;

enum class Scheme : std::uint8_t { lengths = 0, values = 1 };

/// How often each number occurs, up to the largest that does.
using Frequencies = std::vector<std::uint32_t>;

std::uint32_t bit_length(std::uint32_t value) { return static_cast<std::uint32_t>(std::bit_width(value | 1)); }

std::size_t count_different(const Frequencies& frequencies) {
  return frequencies.size() - static_cast<std::size_t>(std::count(frequencies.begin(), frequencies.end(), 0u));
}

// Bits that the symbols take with ideal probabilities.
std::int64_t entropy(const Frequencies& frequencies, std::size_t count) {
  double bits = 0;
  const auto total = static_cast<double>(count);
  for (const std::uint32_t frequency : frequencies) {
    if (frequency > 0) bits += frequency * std::log2(static_cast<double>(frequency) / total);
  }
  return static_cast<std::int64_t>(-bits);
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

// Equal neighbors are the rule, and each would wait for the one before: every other one is counted apart.
Frequencies frequencies_of(std::span<const std::uint32_t> values, std::uint32_t largest) {
  Frequencies even(largest + 1, 0);
  Frequencies odd(largest + 1, 0);
  std::size_t i = 0;
  for (; i + 1 < values.size(); i += 2) {
    ++even[values[i]];
    ++odd[values[i + 1]];
  }
  if (i < values.size()) ++even[values[i]];
  for (std::size_t value = 0; value <= largest; ++value) even[value] += odd[value];
  return even;
}

}  // namespace

struct SymbolCoding::Choice {
  std::vector<std::uint32_t> lengths;
  int table_size = 0;
  RansTable table;
};

SymbolCoding::Choice SymbolCoding::choose(const SymbolRows& symbols, TableEffort effort) {
  const auto columns = static_cast<std::size_t>(symbols.columns);
  std::vector<std::uint32_t> lengths(symbols.rows());
  Frequencies length_frequencies(length_count, 0);
  std::uint32_t all = 0;
  std::int64_t plain_bits = 0;
  for (std::size_t row = 0; row < lengths.size(); ++row) {
    std::uint32_t bits = 0;
    for (std::size_t column = 0; column < columns; ++column) bits |= symbols.values[row * columns + column];
    lengths[row] = bit_length(bits);
    ++length_frequencies[lengths[row]];
    all |= bits;
    plain_bits += lengths[row];
  }
  plain_bits *= symbols.columns;
  while (length_frequencies.back() == 0) length_frequencies.pop_back();
  if (bit_length(all) <= largest_table_size) {
    std::uint32_t largest = *std::max_element(symbols.values.begin(), symbols.values.end());
    const Frequencies frequencies = frequencies_of(symbols.values, largest);
    const std::size_t different = count_different(frequencies);
    const std::size_t different_lengths = count_different(length_frequencies);
    const std::int64_t by_values = entropy(frequencies, symbols.values.size()) + table_bits(largest, different);
    const std::int64_t by_lengths = entropy(length_frequencies, lengths.size()) +
                                    table_bits(different_lengths, different_lengths) + plain_bits;
    if (by_values <= by_lengths) {
      const int table_size = table_size_of(different, effort);
      return {{}, table_size, RansTable(frequencies, precision_bits(table_size))};
    }
  }
  return {std::move(lengths), 0, RansTable(length_frequencies, length_table_bits)};
}

SymbolCoding::SymbolCoding(const SymbolRows& symbols, TableEffort effort)
    : SymbolCoding(symbols, choose(symbols, effort)) {}

SymbolCoding::SymbolCoding(const SymbolRows& symbols, Choice choice)
    : symbols_(symbols),
      lengths_(std::move(choice.lengths)),
      table_size_(choice.table_size),
      table_(std::move(choice.table)) {}

RansInput SymbolCoding::input() const {
  if (lengths_.empty()) return {&table_, symbols_.values.data(), symbols_.rows(), symbols_.columns};
  return {&table_, lengths_.data(), lengths_.size(), 1};
}

void SymbolCoding::write(const std::string& coded, ByteWriter& bytes) const {
  const bool directly = lengths_.empty();
  bytes.byte(static_cast<std::uint8_t>(directly ? Scheme::values : Scheme::lengths));
  if (directly) bytes.byte(static_cast<std::uint8_t>(table_size_));
  table_.write(bytes);
  bytes.block(coded);
  if (directly) return;
  BitWriter plain;
  const auto columns = static_cast<std::size_t>(symbols_.columns);
  for (std::size_t i = 0; i < symbols_.values.size(); ++i) {
    plain.bits(symbols_.values[i], static_cast<int>(lengths_[i / columns]));
  }
  bytes.text(plain.take());
}

void write_symbols(const SymbolRows& symbols, TableEffort effort, ByteWriter& bytes) {
  if (symbols.values.empty()) return;
  const SymbolCoding coding(symbols, effort);
  coding.write(rans_bytes(coding.input()), bytes);
}

}  // namespace dini
