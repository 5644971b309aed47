#include "draco/rans.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <numeric>
#include <utility>

#include "draco/occurring.h"

namespace dini {
namespace {

constexpr std::uint32_t states_per_share = 4;  // a state is at least this often the precision
constexpr std::uint32_t byte_values = 256;

/// Shares with the sum that they have.
struct Shares {
  std::vector<std::uint32_t> values;
  std::uint32_t total = 0;
};

// The shares when each is rounded by itself.
Shares rounded_shares(std::span<const std::uint32_t> frequencies, std::uint32_t precision) {
  const auto total = std::accumulate(frequencies.begin(), frequencies.end(), std::uint64_t{0});
  Shares shares{std::vector<std::uint32_t>(frequencies.size(), 0)};
  for_each_that_occurs(frequencies, [&](std::size_t i, std::uint32_t frequency) {
    const double share = static_cast<double>(frequency) / static_cast<double>(total);
    shares.values[i] = std::max(1u, static_cast<std::uint32_t>(share * precision + 0.5));
    shares.total += shares.values[i];
  });
  return shares;
}

// Takes `excess` from the larger shares, from each in proportion and at least 1, until it is gone.
void take_excess(std::vector<std::uint32_t>& shares, const std::vector<std::uint32_t>& by_size, std::uint32_t precision,
                 std::uint32_t excess) {
  while (excess > 0) {
    const double factor = static_cast<double>(precision) / static_cast<double>(precision + excess);
    for (std::size_t i = by_size.size() - 1; excess > 0 && i > 0; --i) {
      std::uint32_t& share = shares[by_size[i]];
      if (share <= 1) break;
      const auto scaled = static_cast<std::uint32_t>(factor * share);
      const std::uint32_t taken = std::min({std::max(1u, share - scaled), share - 1, excess});
      share -= taken;
      excess -= taken;
    }
  }
}

std::vector<std::uint32_t> shares_of(std::span<const std::uint32_t> frequencies, std::uint32_t precision) {
  auto [shares, total] = rounded_shares(frequencies, precision);
  if (total == precision) return std::move(shares);
  // Of the symbols that do not occur the first one stands for all.
  std::vector<std::uint32_t> by_size;
  const auto none = std::find(shares.begin(), shares.end(), 0u);
  if (none != shares.end()) by_size.push_back(static_cast<std::uint32_t>(none - shares.begin()));
  for_each_that_occurs(shares, [&](std::size_t i, std::uint32_t) { by_size.push_back(static_cast<std::uint32_t>(i)); });
  const std::uint32_t* const values = shares.data();
  std::stable_sort(by_size.begin(), by_size.end(), [values](auto a, auto b) { return values[a] < values[b]; });
  if (total < precision) {
    shares[by_size.back()] += precision - total;
  } else {
    take_excess(shares, by_size, precision, total - precision);
  }
  return std::move(shares);
}

// What a stream ends with: how far its state is above the least one, with the number of its bytes in its two highest
// bits. `target` has room for four bytes; returns the end.
char* write_state(std::uint32_t rest, char* target) {
  const std::uint32_t extra = rest < 1u << 6 ? 0 : rest < 1u << 14 ? 1 : rest < 1u << 22 ? 2 : 3;
  const std::uint32_t last = rest | extra << (6 + 8 * extra);
  std::memcpy(target, &last, sizeof last);
  return target + extra + 1;
}

/// One stream in the making. The state stays below 2^31, so that a product with a reciprocal fits 64 bits.
class RansCoder {
 public:
  RansCoder(const RansTable& table, char* target)
      : table_(&table), bits_(table.bits()), state_(states_per_share << table.bits()), target_(target) {}

  void put(std::uint32_t value) {
    const RansSymbol& symbol = (*table_)[value];
    const std::uint32_t limit = states_per_share * byte_values * symbol.probability;
    // As many of the lowest bytes as the state is too large: up to three, found without a branch.
    const int spilled = (state_ >= limit) + ((state_ >> 8) >= limit) + ((state_ >> 16) >= limit);
    std::memcpy(target_, &state_, sizeof state_);
    target_ += spilled;
    state_ >>= 8 * spilled;
    const auto quotient =
        static_cast<std::uint32_t>((std::uint64_t{state_} * symbol.reciprocal) >> (31 + symbol.shift));
    state_ += quotient * ((1u << bits_) - symbol.probability) + symbol.cumulative;
  }

  char* end() { return write_state(state_ - (states_per_share << bits_), target_); }

 private:
  const RansTable* table_;
  int bits_;
  std::uint32_t state_;
  char* target_;
};

// Where a stream is written: no symbol takes more than three bytes, and the end four.
std::unique_ptr<char[]> room_for(const RansInput& input) {
  return std::make_unique_for_overwrite<char[]>(3 * input.symbols.size() + 8);
}

template <int columns>
void put_row(RansCoder& coder, const std::uint32_t* row) {
  for (int column = columns - 1; column >= 0; --column) coder.put(row[column]);
}

template <int first_columns, int second_columns>
TwoTexts put_rows(const RansInput& first, const RansInput& second) {
  const auto first_room = room_for(first);
  const auto second_room = room_for(second);
  RansCoder one(*first.table, first_room.get());
  RansCoder two(*second.table, second_room.get());
  for (std::size_t row = first.symbols.count; row-- > 0;) {
    put_row<first_columns>(one, first.symbols.row(row));
    put_row<second_columns>(two, second.symbols.row(row));
  }
  return {{first_room.get(), one.end()}, {second_room.get(), two.end()}};
}

template <int columns>
std::string put_rows(const RansInput& input) {
  const auto room = room_for(input);
  RansCoder coder(*input.table, room.get());
  for (std::size_t row = input.symbols.count; row-- > 0;) put_row<columns>(coder, input.symbols.row(row));
  return {room.get(), coder.end()};
}

}  // namespace

RansTable::RansTable(std::span<const std::uint32_t> frequencies, int bits)
    : bits_(bits),
      shares_(shares_of(frequencies, 1u << bits)),
      symbols_(std::make_unique_for_overwrite<RansSymbol[]>(shares_.size())) {
  std::uint32_t cumulative = 0;
  for_each_that_occurs(shares_, [&](std::size_t i, std::uint32_t share) {
    // Division by multiplication (Alverson 1991), exact for states below 2^31.
    const auto shift = static_cast<std::uint32_t>(std::bit_width(share - 1));
    const std::uint64_t reciprocal = ((std::uint64_t{1} << (31 + shift)) + share - 1) / share;
    symbols_[i] = {share, cumulative, static_cast<std::uint32_t>(reciprocal), shift};
    cumulative += share;
  });
}

void RansTable::write(ByteWriter& bytes) const {
  constexpr std::size_t longest_run = 64;
  bytes.varint(static_cast<std::uint32_t>(shares_.size()));
  std::size_t next = 0;
  for_each_that_occurs(shares_, [&](std::size_t i, std::uint32_t share) {
    for (std::size_t run; next < i; next += run) {
      run = std::min(i - next, longest_run);
      bytes.byte(static_cast<std::uint8_t>((run - 1) << 2 | 3));
    }
    const unsigned extra = share < 1u << 6 ? 0 : share < 1u << 14 ? 1 : 2;
    bytes.byte(static_cast<std::uint8_t>(share << 2 | extra));
    for (unsigned byte = 0; byte < extra; ++byte) bytes.byte(static_cast<std::uint8_t>(share >> (8 * byte + 6)));
    next = i + 1;
  });
}

std::string rans_bytes(const RansInput& input) {
  switch (input.symbols.columns) {
    case 1:
      return put_rows<1>(input);
    case 2:
      return put_rows<2>(input);
    case 3:
      return put_rows<3>(input);
    default:
      return put_rows<4>(input);
  }
}

TwoTexts rans_bytes(const RansInput& first, const RansInput& second) {
  const auto are = [&](int first_columns, int second_columns) {
    return first.symbols.count == second.symbols.count && first.symbols.columns == first_columns &&
           second.symbols.columns == second_columns;
  };
  if (are(3, 2)) return put_rows<3, 2>(first, second);
  if (are(2, 4)) return put_rows<2, 4>(first, second);
  return {rans_bytes(first), rans_bytes(second)};
}

void write_bits(const std::vector<bool>& bits, ByteWriter& bytes) {
  constexpr std::uint32_t least_state = 4096;
  const auto zeros = static_cast<double>(std::count(bits.begin(), bits.end(), false));
  const double share = zeros / static_cast<double>(bits.size()) * byte_values + 0.5;
  const std::uint32_t zero = static_cast<std::uint32_t>(std::clamp(share, 1.0, 255.0));
  std::string coded;
  std::uint32_t state = least_state;
  for (std::size_t i = bits.size(); i-- > 0;) {
    const std::uint32_t probability = bits[i] ? byte_values - zero : zero;
    if (state >= least_state * probability) {
      coded.push_back(static_cast<char>(state % byte_values));
      state /= byte_values;
    }
    state = state / probability * byte_values + state % probability + (bits[i] ? 0 : byte_values - zero);
  }
  char last[4];
  coded.append(last, write_state(state - least_state, last));
  bytes.byte(static_cast<std::uint8_t>(zero));
  bytes.block(coded);
}

}  // namespace dini
