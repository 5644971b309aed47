// Uploaded files beside the database: what comes back, what has to go, and what happens when a disk is full.

#include "store/asset_files.h"

#include <catch2/catch.hpp>
#include <csignal>
#include <set>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "store/asset_references.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;
using store::AssetFiles;

namespace {

std::string bytes_of(char letter, std::size_t count = 1000) { return std::string(count, letter); }

/// Files of 1000 bytes each, of which a few are named by graphs.
struct Kept {
  Folder folder;
  std::set<Digest> named;
  std::size_t room = 3000;
  std::unique_ptr<AssetFiles> files = open();

  std::unique_ptr<AssetFiles> open() {
    return std::make_unique<AssetFiles>(folder.path(), room, [this](const Digest& d) { return named.contains(d); });
  }
  std::filesystem::path path(char letter) const { return folder.path() / "assets" / to_hex(sha256(bytes_of(letter))); }
  bool keep(char letter) { return static_cast<bool>(files->keep(sha256(bytes_of(letter)), bytes_of(letter))); }
  bool has(char letter) { return std::filesystem::exists(path(letter)); }
  /// Says when a file was used last, in seconds since 1970.
  void use_at(char letter, int seconds) {
    const std::chrono::sys_seconds time{std::chrono::seconds(seconds)};
    std::filesystem::last_write_time(path(letter), std::filesystem::file_time_type::clock::from_sys(time));
  }
};

}  // namespace

TEST_CASE("An uploaded file comes back byte for byte, after the process too") {
  Kept kept;
  const std::string bytes = std::string("\0\xff any bytes", 12);
  REQUIRE(kept.files->keep(sha256(bytes), bytes));
  CHECK(*kept.files->find(sha256(bytes)) == bytes);
  kept.files = kept.open();
  CHECK(*kept.files->find(sha256(bytes)) == bytes);
  CHECK(kept.files->find(sha256("another")) == nullptr);
}

TEST_CASE("A damaged file is not there, and is whole again when it is uploaded again") {
  Kept kept;
  for (const std::string& damaged : {std::string(), bytes_of('a', 999), bytes_of('a', 999) + "b"}) {
    CAPTURE(damaged.size());
    REQUIRE(kept.keep('a'));
    kept.folder.write("assets/" + kept.path('a').filename().string(), damaged);
    CHECK(kept.files->find(sha256(bytes_of('a'))) == nullptr);
    CHECK(store::fault_in_assets(kept.folder.path()).find(to_hex(sha256(bytes_of('a')))) != std::string::npos);
    REQUIRE(kept.keep('a'));
    CHECK(*kept.files->find(sha256(bytes_of('a'))) == bytes_of('a'));
    CHECK(store::fault_in_assets(kept.folder.path()).empty());
  }
}

TEST_CASE("A link in the folder is never followed") {
  Kept kept;
  REQUIRE(kept.keep('a'));
  kept.folder.write("elsewhere", bytes_of('b'));
  std::filesystem::create_symlink(kept.folder.path() / "elsewhere", kept.path('b'));
  CHECK(kept.files->find(sha256(bytes_of('b'))) == nullptr);
  REQUIRE(kept.keep('b'));
  CHECK_FALSE(std::filesystem::is_symlink(kept.path('b')));
  CHECK(*kept.files->find(sha256(bytes_of('b'))) == bytes_of('b'));
}

TEST_CASE("The files that were used longest ago make room, and those that graphs name do not") {
  Kept kept;
  for (const char letter : {'a', 'b', 'c'}) REQUIRE(kept.keep(letter));
  kept.use_at('a', 1);
  kept.use_at('b', 2);
  kept.use_at('c', 3);
  kept.named = {sha256(bytes_of('a'))};
  REQUIRE(kept.keep('d'));
  CHECK(kept.has('a'));
  CHECK_FALSE(kept.has('b'));
  CHECK(kept.has('c'));

  kept.use_at('d', 4);
  kept.files->note_use(sha256(bytes_of('c')));
  REQUIRE(kept.keep('e'));
  CHECK(kept.has('c'));
  CHECK_FALSE(kept.has('d'));

  kept.use_at('e', 5);
  kept.use_at('c', 6);
  CHECK(kept.files->find(sha256(bytes_of('e'))) != nullptr);
  REQUIRE(kept.keep('f'));
  CHECK(kept.has('e'));
  CHECK_FALSE(kept.has('c'));
}

TEST_CASE("When graphs name everything, a further file is refused and none goes") {
  Kept kept;
  for (const char letter : {'a', 'b', 'c'}) {
    REQUIRE(kept.keep(letter));
    kept.named.insert(sha256(bytes_of(letter)));
  }
  kept.named.erase(sha256(bytes_of('a')));
  const std::string large = bytes_of('x', 1001);
  const auto refused = kept.files->keep(sha256(large), large);
  REQUIRE_FALSE(refused);
  CHECK(refused.problems().front().code == "storage-full");
  CHECK(refused.problems().front().detail.find("`asset_file_bytes`") != std::string::npos);
  for (const char letter : {'a', 'b', 'c'}) CHECK(kept.has(letter));
  CHECK(kept.keep('a'));
}

TEST_CASE("A disk that is full is told of, leaves nothing behind, and is tried again") {
  Kept kept;
  REQUIRE(kept.keep('a'));
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{500, 500};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const auto refused = kept.files->keep(sha256(bytes_of('b')), bytes_of('b'));
    const bool told = !refused && refused.problems().front().code == "storage-full";
    const bool reads = kept.files->find(sha256(bytes_of('a'))) != nullptr;
    ::_exit(told && reads ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  CHECK(std::distance(std::filesystem::directory_iterator(kept.folder.path() / "assets"), {}) == 1);
  CHECK(kept.keep('b'));
}

TEST_CASE("What a process left that ended while it wrote is gone with the next one") {
  Kept kept;
  REQUIRE(kept.keep('a'));
  kept.folder.write("assets/" + to_hex(sha256("b")) + ".new", "half of");
  kept.files = kept.open();
  CHECK(std::distance(std::filesystem::directory_iterator(kept.folder.path() / "assets"), {}) == 1);
}

TEST_CASE("A copy of the files has all that are whole, and names one that is not") {
  Kept kept;
  const std::filesystem::path target = kept.folder.path() / "copy";
  CHECK(*store::copy_assets(kept.folder.path(), target) == 0);
  CHECK_FALSE(std::filesystem::exists(target));
  REQUIRE(kept.keep('a'));
  REQUIRE(kept.keep('b'));
  CHECK(*store::copy_assets(kept.folder.path(), target) == 2);
  CHECK(kept.folder.read("copy/" + kept.path('a').filename().string()) == bytes_of('a'));
  kept.folder.write("assets/" + kept.path('a').filename().string(), "damaged");
  const auto partly = store::copy_assets(kept.folder.path(), kept.folder.path() / "second");
  REQUIRE_FALSE(partly);
  CHECK(partly.problems().front().detail.find(to_hex(sha256(bytes_of('a')))) != std::string::npos);
  CHECK(std::filesystem::exists(kept.folder.path() / "second" / kept.path('b').filename()));
}

TEST_CASE("A document names the files whose hashes it has as texts") {
  const std::string a = to_hex(sha256("a")), b = to_hex(sha256("b"));
  CHECK(store::assets_named_in("{\"asset\":\"" + a + "\",\"x\":[\"" + b + "\"]}") ==
        std::vector<Digest>{sha256("a"), sha256("b")});
  CHECK(store::assets_named_in("\"" + a + "\"") == std::vector<Digest>{sha256("a")});
  for (const std::string& other :
       {std::string(), std::string("\""), "\"" + a, "\"" + a + "0\"", "\"x" + a + "\"", "\"" + a.substr(1) + "\"", a}) {
    CHECK(store::assets_named_in(other).empty());
  }
}
