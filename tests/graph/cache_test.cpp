#include "graph/cache.h"

#include <catch2/catch.hpp>
#include <string>

using namespace dini;

namespace {

Digest key(const std::string& text) { return sha256(text); }

void insert(Cache& cache, const std::string& name, std::size_t bytes, const std::string& place = "") {
  const std::optional<Digest> where = place.empty() ? std::nullopt : std::optional(key("place " + place));
  cache.insert<std::string>(key(name), std::make_shared<std::string>(name), bytes, where);
}

constexpr std::size_t megabyte = std::size_t{1} << 20;

}  // namespace

TEST_CASE("A cache gives back what was put in, and the least recently used makes room") {
  Cache cache(10'000);
  insert(cache, "a", 4'000);
  insert(cache, "b", 4'000);
  REQUIRE(cache.find<std::string>(key("a")));
  CHECK(*cache.find<std::string>(key("a")) == "a");
  insert(cache, "c", 4'000);
  CHECK(cache.contains(key("a")));
  CHECK_FALSE(cache.contains(key("b")));
  CHECK(cache.contains(key("c")));
  CHECK(cache.evictions() == 1);
  insert(cache, "larger than all", 20'000);
  CHECK(cache.size() == 2);
  cache.clear();
  CHECK(cache.size() == 0);
  CHECK(cache.bytes() == 0);
  CHECK_FALSE(cache.find<std::string>(key("a")));
}

TEST_CASE("Of the large versions of one place the last few are kept, used ones longest") {
  Cache cache(1'000 * megabyte);
  for (int k = 0; k < 4; ++k) insert(cache, "surface " + std::to_string(k), 3 * megabyte, "surface");
  insert(cache, "field", 3 * megabyte, "field");
  CHECK(cache.size() == 5);
  REQUIRE(cache.find<std::string>(key("surface 0")));
  insert(cache, "surface 4", 3 * megabyte, "surface");
  CHECK(cache.contains(key("surface 0")));
  CHECK_FALSE(cache.contains(key("surface 1")));
  CHECK(cache.contains(key("surface 4")));
  CHECK(cache.contains(key("field")));
  insert(cache, "surface 4", 3 * megabyte, "surface");
  CHECK(cache.size() == 5);
}

TEST_CASE("Small versions and things without a place are bounded by the budget alone") {
  Cache cache(1'000 * megabyte);
  for (int k = 0; k < 20; ++k) insert(cache, "small " + std::to_string(k), megabyte, "curve");
  for (int k = 0; k < 20; ++k) insert(cache, "file " + std::to_string(k), 3 * megabyte);
  CHECK(cache.size() == 40);
  CHECK(cache.evictions() == 0);
}

TEST_CASE("A place is forgotten with its versions") {
  Cache cache(10 * megabyte);
  for (int k = 0; k < 40; ++k) insert(cache, "surface " + std::to_string(k), 3 * megabyte, std::to_string(k % 7));
  CHECK(cache.size() == 3);
  CHECK(cache.evictions() == 37);
  CHECK(cache.contains(key("surface 39")));
}
