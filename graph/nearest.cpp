#include "graph/nearest.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace dini {

namespace {

constexpr std::size_t longest_name = 64;

/// The edit distance of `pattern`, of 1 to 64 bytes, to other texts: one column of the table of distances at a time, as
/// the bits of a word (Myers 1999, in the form of Hyyro 2001).
class EditDistance {
 public:
  explicit EditDistance(std::string_view pattern) : size_(pattern.size()) {
    for (std::size_t i = 0; i < size_; ++i) places_[static_cast<unsigned char>(pattern[i])] |= std::uint64_t{1} << i;
  }

  std::size_t to(std::string_view text) const {
    const std::uint64_t last = std::uint64_t{1} << (size_ - 1);
    std::uint64_t rises = ~std::uint64_t{0}, falls = 0;  // where a distance is one above or below its upper neighbor
    std::size_t distance = size_;
    for (const char c : text) {
      const std::uint64_t equal = places_[static_cast<unsigned char>(c)];
      const std::uint64_t diagonal = (((equal & rises) + rises) ^ rises) | equal | falls;
      std::uint64_t right_rises = falls | ~(diagonal | rises), right_falls = rises & diagonal;
      if ((right_rises & last) != 0) ++distance;
      if ((right_falls & last) != 0) --distance;
      right_rises = right_rises << 1 | 1;
      right_falls <<= 1;
      rises = right_falls | ~(diagonal | right_rises);
      falls = right_rises & diagonal;
    }
    return distance;
  }

 private:
  std::size_t size_;
  std::array<std::uint64_t, 256> places_{};
};

}  // namespace

std::string nearest(std::string_view given, const std::vector<std::string>& known) {
  if (given.empty() || given.size() > longest_name) return "";
  const EditDistance distance(given);
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, given.size() / 2) + 1;
  for (const std::string& name : known) {
    const std::size_t apart = name.size() > given.size() ? name.size() - given.size() : given.size() - name.size();
    if (apart >= best_distance) continue;
    const std::size_t found = distance.to(name);
    if (found < best_distance) {
      best = name;
      best_distance = found;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view given, const std::vector<std::string>& known) {
  const std::string name = nearest(given, known);
  return name.empty() ? "" : "; did you mean \"" + name + "\"?";
}

}  // namespace dini
