#include "graph/nearest.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <random>

using namespace dini;

namespace {

/// The distance by the table of the definition.
std::size_t slow_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::vector<std::size_t> next(b.size() + 1, i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      next[j + 1] = std::min({row[j + 1] + 1, next[j] + 1, row[j] + (a[i] == b[j] ? 0 : 1)});
    }
    row = next;
  }
  return row.back();
}

/// The nearest by the definition: the first of those with the least distance, if it is at most half of the text.
std::string slow_nearest(const std::string& given, const std::vector<std::string>& known) {
  std::string best;
  std::size_t least = std::max<std::size_t>(1, given.size() / 2) + 1;
  for (const std::string& name : known) {
    const std::size_t distance = slow_distance(given, name);
    if (distance < least) {
      least = distance;
      best = name;
    }
  }
  return best;
}

}  // namespace

TEST_CASE("The nearest name is that of the definition, for names of every length") {
  std::mt19937 random(7);
  const auto word = [&](std::size_t longest) {
    std::string text(1 + random() % longest, 'a');
    for (char& c : text) c = static_cast<char>('a' + random() % 4);
    return text;
  };
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::string> known;
    for (int i = 0; i < 6; ++i) known.push_back(word(round % 2 == 0 ? 8 : 90));
    std::string given = word(round % 2 == 0 ? 8 : 64);
    if (round % 3 == 0) given = known[random() % 6].substr(0, 64);
    if (round % 3 == 0 && given.size() > 1) given[random() % given.size()] = 'z';
    CAPTURE(given, known);
    REQUIRE(nearest(given, known) == slow_nearest(given, known));
  }
  CHECK(nearest(std::string(64, 'x'), {std::string(63, 'x')}) == std::string(63, 'x'));
  CHECK(nearest(std::string(65, 'x'), {std::string(65, 'x')}).empty());
  CHECK(nearest("", {"a"}).empty());
}
