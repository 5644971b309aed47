#include "geometry/spare_memory.h"

#include <catch2/catch.hpp>
#include <cstdint>
#include <cstring>
#include <set>
#include <thread>
#include <vector>

#include "geometry/large_memory.h"
#include "geometry/zeroed.h"

using namespace dini;

namespace {

/// What was given back to the system, as numbers that stand for addresses.
std::vector<std::uintptr_t> returned;

void* piece(std::uintptr_t number) { return reinterpret_cast<void*>(number); }
void note(void* memory, std::size_t) noexcept { returned.push_back(reinterpret_cast<std::uintptr_t>(memory)); }

}  // namespace

TEST_CASE("A freed piece serves the next of its size, the last one first") {
  returned.clear();
  SpareMemory spare(1'000, note);
  CHECK(spare.take(100) == nullptr);
  spare.keep(piece(1), 100);
  spare.keep(piece(2), 200);
  spare.keep(piece(3), 100);
  CHECK(spare.bytes() == 400);
  CHECK(spare.take(100) == piece(3));
  CHECK(spare.take(100) == piece(1));
  CHECK(spare.take(100) == nullptr);
  CHECK(spare.bytes() == 200);
  CHECK(returned.empty());
}

TEST_CASE("What is more than the limit goes back to the system, the oldest first") {
  returned.clear();
  SpareMemory spare(300, note);
  for (std::uintptr_t number = 1; number <= 4; ++number) spare.keep(piece(number), 100);
  CHECK(returned == std::vector<std::uintptr_t>{1});
  spare.keep(piece(5), 301);
  CHECK(returned == std::vector<std::uintptr_t>{1, 5});
  spare.limit(100);
  CHECK(returned == std::vector<std::uintptr_t>{1, 5, 2, 3});
  CHECK(spare.give_back() == 100);
  CHECK(spare.give_back() == 0);
  CHECK(returned == std::vector<std::uintptr_t>{1, 5, 2, 3, 4});
}

TEST_CASE("Never are more than a few pieces kept, and each goes back once") {
  returned.clear();
  SpareMemory spare(1'000'000, note);
  for (std::uintptr_t number = 1; number <= 500; ++number) spare.keep(piece(number), 1);
  CHECK(spare.bytes() == 128);
  spare.give_back();
  CHECK(returned.size() == 500);
  CHECK(std::set(returned.begin(), returned.end()).size() == 500);
}

TEST_CASE("Large arrays begin with zeros also where others were before") {
  const std::size_t size = 600'001;
  for (int round = 0; round < 3; ++round) {
    Zeroed<double> numbers(size);
    std::size_t others = 0;
    for (const double number : numbers) others += number == 0 ? 0 : 1;
    CHECK(others == 0);
    std::memset(static_cast<void*>(numbers.data()), 0x5a, size * sizeof(double));
  }
  CHECK(give_back_spare_memory() == is_large_memory(size * sizeof(double)));
  CHECK_FALSE(give_back_spare_memory());
}

TEST_CASE("Threads that free and take large arrays never share one") {
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (unsigned number = 0; number < 4; ++number) {
    threads.emplace_back([&, number] {
      for (int round = 0; round < 50; ++round) {
        Zeroed<std::uint64_t> numbers(300'000 + 1'000 * (round % 3));
        for (std::size_t i = 0; i < numbers.size(); i += 997) numbers[i] += number + 1;
        for (std::size_t i = 0; i < numbers.size(); i += 997) wrong[number] += numbers[i] == number + 1 ? 0 : 1;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == std::vector<int>(4, 0));
}
