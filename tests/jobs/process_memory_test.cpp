#include "jobs/process_memory.h"

#include <catch2/catch.hpp>

#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

constexpr std::size_t mebibyte = 1 << 20;

std::size_t available(const Folder& folder, const std::string& membership) {
  folder.write("membership", membership);
  return jobs::available_bytes(folder.path() / "groups", folder.path() / "membership");
}

}  // namespace

TEST_CASE("The memory that may be held is the machine's where nothing limits it") {
  const Folder folder;
  const std::size_t machine = available(folder, "");
  CHECK(machine > 100 * mebibyte);
  CHECK(machine >= jobs::available_bytes());
  folder.write("groups/memory.max", "max\n");
  folder.write("groups/memory/memory.limit_in_bytes", "9223372036854771712\n");
  CHECK(available(folder, "0::/\n1:memory:/\n") == machine);
  CHECK(available(folder, "nonsense\n0:\n::\n") == machine);
}

TEST_CASE("The least limit of a control group and those around it holds, in both versions") {
  const Folder folder;
  folder.write("groups/memory.max", std::to_string(90 * mebibyte));
  folder.write("groups/service/memory.max", std::to_string(50 * mebibyte));
  folder.write("groups/service/part/memory.max", "max\n");
  folder.write("groups/memory/memory.limit_in_bytes", std::to_string(80 * mebibyte));
  folder.write("groups/memory/service/memory.limit_in_bytes", std::to_string(40 * mebibyte));
  CHECK(available(folder, "0::/\n") == 90 * mebibyte);
  CHECK(available(folder, "0::/service/part\n") == 50 * mebibyte);
  CHECK(available(folder, "5:cpu:/service\n4:memory:/\n0::/\n") == 80 * mebibyte);
  CHECK(available(folder, "4:memory:/service\n") == 40 * mebibyte);
  // A container does not see the path that its machine has for it.
  CHECK(available(folder, "0::/machine/of/it\n") == 90 * mebibyte);
}
