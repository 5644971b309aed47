// `dini store`: what an operator sees of the graphs that a server keeps.

#include <catch2/catch.hpp>

#include "store/graph_store.h"
#include "tests/cli/program.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

constexpr std::size_t room = 64 << 20;
const store::Condition always = [](const store::GraphVersion*) { return true; };

std::unique_ptr<store::GraphStore> opened(const std::filesystem::path& folder) {
  auto store = store::GraphStore::open(folder, room);
  REQUIRE(store);
  return *std::move(store);
}

/// Keeps two graphs, and deletes one of them.
std::unique_ptr<store::GraphStore> filled(const std::filesystem::path& folder) {
  auto store = opened(folder);
  REQUIRE(store->put({.id = "chair", .title = "A chair\x1b[2J", .document = "one"}, always));
  REQUIRE(store->put({.id = "lamp", .title = "A lamp", .document = "two"}, always));
  REQUIRE(store->remove("lamp", always));
  return store;
}

}  // namespace

TEST_CASE("The store is listed, checked and backed up while a server has it, and purged when none does") {
  const Folder folder;
  const std::string data = (folder.path() / "data").string();
  const std::string backup = (folder.path() / "backup.db").string();
  auto store = filled(data);

  const Outcome list = run_dini({"store", "list", "--data", data});
  CHECK(list.code == 0);
  CHECK(list.out.starts_with("chair@1\t3\t"));
  CHECK(list.out.find('\x1b') == std::string::npos);
  CHECK(list.out.find("lamp") == std::string::npos);
  CHECK(run_dini({"store", "check", "--data", data}).code == 0);
  CHECK(run_dini({"store", "backup", backup, "--data", data}).code == 0);
  CHECK(run_dini({"store", "backup", backup, "--data", data}).code == 6);
  const Outcome early = run_dini({"store", "purge", "--data", data});
  CHECK(early.code == 6);
  CHECK(early.err.find("another process") != std::string::npos);

  store = nullptr;
  CHECK(run_dini({"store", "purge", "--data", data}).out == "1 deleted graph is gone for ever.\n");
  CHECK(run_dini({"store", "purge", "--data", data}).out == "0 deleted graphs are gone for ever.\n");
  CHECK(opened(data)->versions("lamp")->empty());

  std::filesystem::create_directories(folder.path() / "restored");
  std::filesystem::rename(backup, folder.path() / "restored" / "dini.db");
  CHECK(opened(folder.path() / "restored")->versions("lamp")->size() == 1);
}

TEST_CASE("Uploaded files are checked and backed up with the graphs") {
  const Folder folder;
  const std::string data = (folder.path() / "data").string(), backup = (folder.path() / "backup.db").string();
  filled(data);
  const std::string name = to_hex(sha256("a mesh"));
  folder.write("data/assets/" + name, "a mesh");
  CHECK(run_dini({"store", "check", "--data", data}).code == 0);
  CHECK(run_dini({"store", "backup", backup, "--data", data}).code == 0);
  CHECK(folder.read("backup.db.assets/" + name) == "a mesh");
  std::filesystem::remove(backup);
  CHECK(run_dini({"store", "backup", backup, "--data", data}).code == 6);
  CHECK_FALSE(std::filesystem::exists(backup));

  folder.write("data/assets/" + name, "a mess");
  const Outcome check = run_dini({"store", "check", "--data", data});
  CHECK(check.code == 6);
  CHECK(check.err.find(name) != std::string::npos);
  const Outcome partly = run_dini({"store", "backup", backup + "2", "--data", data});
  CHECK(partly.code == 6);
  CHECK(partly.err.find(name) != std::string::npos);
}

TEST_CASE("A store that is not there or is damaged is told of in one line") {
  const Folder folder;
  for (const char* command : {"list", "check", "purge"}) {
    const Outcome outcome = run_dini({"store", command, "--data", (folder.path() / "nowhere").string()});
    CAPTURE(command, outcome.err);
    CHECK(outcome.code == 6);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  CHECK_FALSE(std::filesystem::exists(folder.path() / "nowhere"));
  filled(folder.path() / "data");
  std::string bytes = folder.read("data/dini.db");
  const auto at = bytes.rfind("one");
  REQUIRE(at != std::string::npos);
  bytes.replace(at, 3, "not");
  folder.write("data/dini.db", bytes);
  const Outcome check = run_dini({"store", "check", "--data", (folder.path() / "data").string()});
  CHECK(check.code == 6);
  CHECK(check.err.find("chair") != std::string::npos);
  CHECK(run_dini({"store"}).code == 2);
  CHECK(run_dini({"store", "repair"}).code == 2);
}

TEST_CASE("A server says at once that it cannot use its data folder") {
  const Folder folder;
  const std::string data = folder.path().string();
  const auto held = opened(data);
  const Outcome outcome = run_dini({"serve", "--port", "0", "--data", data});
  CHECK(outcome.code == 6);
  CHECK(outcome.err.find("another process has this data folder open") != std::string::npos);
}
