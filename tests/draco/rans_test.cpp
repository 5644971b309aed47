#include "draco/rans.h"

#include <catch2/catch.hpp>
#include <random>

#include "draco/bit_writer.h"

using namespace dini;

namespace {

// As decoders read it (bitstream 2.2, "RansRead").
std::vector<std::uint32_t> decoded(const std::string& bytes, const RansTable& table, std::uint32_t symbols,
                                   std::size_t count) {
  const std::uint32_t precision = 1u << table.bits();
  const auto at = [&](std::size_t index) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[index]));
  };
  std::size_t left = bytes.size() - 1 - (at(bytes.size() - 1) >> 6);
  std::uint32_t state = 0;
  for (std::size_t i = bytes.size(); i-- > left;) state = state << 8 | at(i);
  state = (state & ((1u << (8 * (bytes.size() - left) - 2)) - 1)) + 4 * precision;
  std::vector<std::uint32_t> values;
  while (values.size() < count) {
    while (state < 4 * precision && left > 0) state = state << 8 | at(--left);
    const std::uint32_t rest = state % precision;
    std::uint32_t symbol = symbols - 1;
    while (table.shares()[symbol] == 0 || table[symbol].cumulative > rest) --symbol;
    state = state / precision * table[symbol].probability + rest - table[symbol].cumulative;
    values.push_back(symbol);
  }
  return values;
}

TEST_CASE("What is coded is decoded again, however rare or frequent symbols are") {
  const int bits = GENERATE(12, 15, 20);
  const double skew = GENERATE(0.01, 0.3, 0.9);
  const std::uint32_t symbols = GENERATE(1u, 2u, 40u, 1000u);
  CAPTURE(bits, skew, symbols);
  std::mt19937 random(5);
  std::geometric_distribution<std::uint32_t> distribution(skew);
  std::vector<std::uint32_t> values(6000);
  std::vector<std::uint32_t> frequencies(symbols, 0);
  for (std::uint32_t& value : values) ++frequencies[value = distribution(random) % symbols];
  while (frequencies.back() == 0) frequencies.pop_back();
  const RansTable table(frequencies, bits);
  const auto size = static_cast<std::uint32_t>(frequencies.size());
  std::uint32_t total = 0;
  for (std::uint32_t symbol = 0; symbol < size; ++symbol) {
    CHECK((table.shares()[symbol] > 0) == (frequencies[symbol] > 0));
    total += table.shares()[symbol];
  }
  CHECK(total == 1u << bits);
  const int columns = GENERATE(1, 2, 3, 4);
  const SymbolRows rows = {values.data(), values.size() / static_cast<std::size_t>(columns), columns,
                           static_cast<std::size_t>(columns)};
  const std::string bytes = rans_bytes({&table, rows});
  CHECK(decoded(bytes, table, size, values.size()) == values);
  const TwoTexts twice = rans_bytes({&table, rows}, {&table, rows});
  CHECK(twice.first == bytes);
  CHECK(twice.second == bytes);
}

TEST_CASE("Two inputs side by side give the bytes of each alone") {
  std::mt19937 random(6);
  std::vector<std::uint32_t> values(4 * 500);
  for (std::uint32_t& value : values) value = static_cast<std::uint32_t>(random() % 7);
  const std::vector<std::uint32_t> frequencies(7, 300);
  const RansTable table(frequencies, 12);
  const RansInput three = {&table, {values.data(), 500, 3, 4}};
  const RansInput two = {&table, {values.data(), 500, 2, 4}};
  const RansInput four = {&table, {values.data(), 500, 4, 4}};
  CHECK(rans_bytes(three, two).first == rans_bytes(three));
  CHECK(rans_bytes(three, two).second == rans_bytes(two));
  CHECK(rans_bytes(two, four).first == rans_bytes(two));
  CHECK(rans_bytes(two, four).second == rans_bytes(four));
}

TEST_CASE("Bits fill bytes from below") {
  BitWriter bits;
  bits.bits(1, 1);
  bits.bits(0b10, 2);
  bits.bits(0xffffffff, 32);
  CHECK(bits.take() == std::string("\xfd\xff\xff\xff\x07", 5));
}

}  // namespace
