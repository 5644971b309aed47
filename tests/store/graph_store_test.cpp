// Graphs that are kept: what comes back, what is refused, and what happens to the folder that they are in.

#include "store/graph_store.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;
using store::GraphStore;
using store::GraphVersion;
using store::WriteOutcome;

namespace {

constexpr std::size_t room = 64 << 20;

const store::Condition always = [](const GraphVersion*) { return true; };
const store::Condition when_absent = [](const GraphVersion* current) { return current == nullptr; };

store::NewGraph graph(const std::string& id, std::string_view document, const std::string& title = "") {
  return {.id = id, .hash = sha256("graph"), .title = title, .document = document};
}

WriteOutcome put(GraphStore& store, const std::string& id, std::string_view document,
                 const store::Condition& condition = always) {
  const auto written = store.put(graph(id, document), condition);
  REQUIRE(written);
  return written->outcome;
}

/// The document of a graph; empty when there is none.
std::string document(const GraphStore& store, const std::string& id, std::optional<std::int64_t> version = {}) {
  const auto found = store.find(id, version);
  REQUIRE(found);
  return *found ? *(*found)->document : "";
}

std::vector<std::string> ids(const store::GraphPage& page) {
  std::vector<std::string> ids;
  for (const GraphVersion& version : page.graphs) ids.push_back(version.id);
  return ids;
}

std::unique_ptr<GraphStore> opened(const std::filesystem::path& folder) {
  auto store = GraphStore::open(folder, room);
  REQUIRE(store);
  return *std::move(store);
}

/// Why a folder cannot be opened; empty when it can.
std::string refusal(const std::filesystem::path& folder) {
  const auto store = GraphStore::open(folder, room);
  if (store) return "";
  CHECK(store.problems().size() == 1);
  CHECK(store.problems().front().code == "io");
  const std::string detail = store.problems().front().detail;
  CHECK(detail.find('\n') == std::string::npos);
  return detail;
}

}  // namespace

TEST_CASE("What is kept comes back byte for byte, whatever its characters are") {
  const auto store = GraphStore::in_memory(room);
  const std::string all = std::string("'; DROP TABLE graphs; --") + '\0' + "\xff%_\\\"\u202e";
  CHECK(put(*store, "a", all) == WriteOutcome::created);
  CHECK(document(*store, "a") == all);
  const auto found = store->look_up("a", std::nullopt);
  REQUIRE(*found);
  CHECK((*found)->version == 1);
  CHECK((*found)->bytes == static_cast<std::int64_t>(all.size()));
  CHECK((*found)->digest == sha256(all));
  CHECK((*found)->hash == sha256("graph"));
  CHECK((*found)->created > 1'700'000'000'000);
}

TEST_CASE("Versions count up, never change, and outlive their graph") {
  const auto store = GraphStore::in_memory(room);
  CHECK(put(*store, "a", "one") == WriteOutcome::created);
  CHECK(put(*store, "a", "two") == WriteOutcome::replaced);
  CHECK(put(*store, "a", "two", when_absent) == WriteOutcome::unchanged);
  CHECK(document(*store, "a") == "two");
  CHECK(document(*store, "a", 1) == "one");
  CHECK(document(*store, "a", 3).empty());
  CHECK(store->remove("a", always)->outcome == WriteOutcome::deleted);
  CHECK(store->remove("a", always)->outcome == WriteOutcome::unchanged);
  CHECK(document(*store, "a").empty());
  CHECK(document(*store, "a", 2) == "two");
  CHECK(put(*store, "a", "two", when_absent) == WriteOutcome::created);
  const auto versions = store->versions("a");
  REQUIRE(versions->size() == 3);
  CHECK(versions->front().version == 3);
  CHECK(store->versions("b")->empty());
}

TEST_CASE("A condition sees the current version, and without it nothing is written") {
  const auto store = GraphStore::in_memory(room);
  put(*store, "a", "one");
  const auto refused = store->put(graph("a", "two"), when_absent);
  CHECK(refused->outcome == WriteOutcome::refused);
  CHECK(refused->current->version == 1);
  CHECK(store->remove("a", when_absent)->outcome == WriteOutcome::refused);
  CHECK(document(*store, "a") == "one");
}

TEST_CASE("Of many who replace the same version one succeeds") {
  const Folder folder;
  const auto store = opened(folder.path());
  put(*store, "a", "first");
  std::atomic<int> replaced = 0;
  std::vector<std::thread> writers;
  for (int i = 0; i < 8; ++i) {
    writers.emplace_back([&, i] {
      const auto written = store->put(graph("a", "by " + std::to_string(i)),
                                      [](const GraphVersion* current) { return current->version == 1; });
      if (written && written->outcome == WriteOutcome::replaced) ++replaced;
    });
  }
  for (std::thread& writer : writers) writer.join();
  CHECK(replaced == 1);
  CHECK(store->versions("a")->size() == 2);
}

TEST_CASE("A list has pages, and finds what is looked for and nothing else") {
  const auto store = GraphStore::in_memory(room);
  for (const char* id : {"chair", "lamp", "stool", "table"}) {
    REQUIRE(store->put(graph(id, id, std::string("A 100% ") + id), always));
  }
  const auto first = store->list("", "", 3);
  CHECK(ids(*first) == std::vector<std::string>{"chair", "lamp", "stool"});
  CHECK(first->more);
  const auto second = store->list("stool", "", 3);
  CHECK(ids(*second) == std::vector<std::string>{"table"});
  CHECK_FALSE(second->more);
  CHECK(ids(*store->list("", "LAMP", 10)) == std::vector<std::string>{"lamp"});
  CHECK(store->list("", "0%", 10)->graphs.size() == 4);
  CHECK(store->list("", "0_", 10)->graphs.empty());
  CHECK(store->list("", "\\", 10)->graphs.empty());
  store->remove("lamp", always);
  CHECK(store->list("", "", 10)->graphs.size() == 3);
}

TEST_CASE("What was kept is there after the process") {
  const Folder folder;
  put(*opened(folder.path()), "a", "one");
  CHECK(document(*opened(folder.path()), "a") == "one");
}

TEST_CASE("A process that is killed while it writes has kept everything that it was told is kept") {
  const Folder folder;
  for (int round = 0; round < 5; ++round) {
    int told[2];
    REQUIRE(::pipe(told) == 0);
    const pid_t child = ::fork();
    if (child == 0) {
      auto store = GraphStore::open(folder.path(), room);
      for (int i = 0; store; ++i) {
        const std::string document = std::to_string(round) + "." + std::to_string(i);
        if (!(*store)->put(graph("g" + std::to_string(i), document), always)) break;
        if (::write(told[1], &i, sizeof(i)) != sizeof(i)) break;
      }
      ::_exit(1);
    }
    ::close(told[1]);
    int last = -1;
    for (int i = 0; last < 20 && ::read(told[0], &i, sizeof(i)) == sizeof(i);) last = i;
    ::kill(child, SIGKILL);
    for (int i = 0; ::read(told[0], &i, sizeof(i)) == sizeof(i);) last = i;
    ::close(told[0]);
    ::waitpid(child, nullptr, 0);
    REQUIRE(last >= 20);
    const auto store = opened(folder.path());
    CHECK(store->fault()->empty());
    for (int i = 0; i <= last; ++i) {
      CHECK(document(*store, "g" + std::to_string(i)) == std::to_string(round) + "." + std::to_string(i));
    }
  }
}

TEST_CASE("A data folder is used by one process at a time") {
  const Folder folder;
  const auto store = opened(folder.path());
  CHECK(refusal(folder.path()).find("another process has this data folder open") != std::string::npos);
  put(*store, "a", "one");
  const auto reader = GraphStore::open_to_read(folder.path());
  REQUIRE(reader);
  CHECK(document(**reader, "a") == "one");
}

TEST_CASE("A damaged, foreign or lost database is told of and left alone") {
  const Folder folder;
  put(*opened(folder.path()), "a", std::string(100'000, 'a'));
  const std::filesystem::path file = folder.path() / "dini.db";
  const std::string whole = folder.read("dini.db");

  const auto with = [&](const std::string& bytes) {
    folder.write("dini.db", bytes);
    const std::string reason = refusal(folder.path());
    CHECK(folder.read("dini.db") == bytes);
    return reason;
  };
  std::string damaged = whole;
  damaged.replace(4096 * 2, 4096, std::string(4096, 'x'));
  CHECK(with(damaged).find("damaged") != std::string::npos);
  CHECK(with("this is text and nothing else, long enough for a header" + std::string(200, '.')).find("damaged") !=
        std::string::npos);
  CHECK(with("").find("no database of Dini") != std::string::npos);

  folder.write("dini.db", whole);
  folder.write("notes.txt", "mine");
  std::filesystem::remove(file);
  CHECK(refusal(folder.path()).find("the database is missing") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("What does not fit is refused, and what is kept stays readable") {
  const Folder folder;
  auto store = GraphStore::open(folder.path(), 1 << 18);
  REQUIRE(store);
  put(**store, "small", "one");
  const auto large = (*store)->put(graph("large", std::string(1 << 18, 'x')), always);
  REQUIRE_FALSE(large);
  CHECK(large.problems().front().code == "storage-full");
  CHECK(document(**store, "small") == "one");
  CHECK(document(**store, "large").empty());
  CHECK(put(**store, "other", "two") == WriteOutcome::created);
}

TEST_CASE("A store that refuses says why, and reads as empty") {
  const auto store = GraphStore::refusing("There is no folder.");
  const auto written = store->put(graph("a", "one"), always);
  REQUIRE_FALSE(written);
  CHECK(written.problems().front().code == "storage-failed");
  CHECK(written.problems().front().detail == "There is no folder.");
  CHECK(store->list("", "", 10)->graphs.empty());
}

TEST_CASE("Deleted graphs are purged with all their versions, and others are not") {
  const Folder folder;
  const auto store = opened(folder.path());
  put(*store, "a", "one");
  put(*store, "b", "one");
  put(*store, "b", "two");
  store->remove("b", always);
  CHECK(*store->purge() == 1);
  CHECK(*store->purge() == 0);
  CHECK(document(*store, "a") == "one");
  CHECK(document(*store, "b", 1).empty());
}

TEST_CASE("A backup made while graphs are written is a database with all of them") {
  const Folder folder;
  const auto store = opened(folder.path() / "data");
  put(*store, "a", "one");
  const auto reader = GraphStore::open_to_read(folder.path() / "data");
  REQUIRE(reader);
  std::filesystem::create_directories(folder.path() / "restored");
  REQUIRE((*reader)->back_up(folder.path() / "restored" / "dini.db"));
  put(*store, "b", "two");
  CHECK(document(*opened(folder.path() / "restored"), "a") == "one");
  CHECK_FALSE((*reader)->back_up(folder.path() / "data" / "dini.db"));
}

TEST_CASE("The files that graphs name are known until their graph is purged") {
  const auto store = GraphStore::in_memory(room);
  const Digest digest = sha256("file");
  CHECK_FALSE(*store->names(digest));
  put(*store, "a", "{\"asset\":\"" + to_hex(digest) + "\"}");
  put(*store, "a", "without");
  CHECK(*store->names(digest));
  store->remove("a", always);
  CHECK(*store->names(digest));
  REQUIRE(store->purge());
  CHECK_FALSE(*store->names(digest));
}

TEST_CASE("A database of version 1 is opened as it is, and knows which files its graphs name") {
  const Folder folder;
  const std::string text = "{\"asset\":\"" + to_hex(sha256("file")) + "\"}";
  {
    SQLite::Database database((folder.path() / "dini.db").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    database.exec(R"(
      PRAGMA application_id = 1147760233;
      PRAGMA user_version = 1;
      CREATE TABLE versions (id TEXT NOT NULL, version INTEGER NOT NULL, created INTEGER NOT NULL, hash BLOB NOT NULL,
        digest BLOB NOT NULL, bytes INTEGER NOT NULL, title TEXT NOT NULL, document BLOB NOT NULL,
        PRIMARY KEY (id, version));
      CREATE TABLE graphs (id TEXT PRIMARY KEY, version INTEGER NOT NULL, deleted INTEGER,
        FOREIGN KEY (id, version) REFERENCES versions (id, version)) WITHOUT ROWID;
    )");
    SQLite::Statement insert(database, "INSERT INTO versions VALUES ('a', 1, 0, ?1, ?1, ?2, 'A', ?3)");
    const Digest digest = sha256(text);
    insert.bind(1, digest.data(), static_cast<int>(digest.size()));
    insert.bind(2, static_cast<std::int64_t>(text.size()));
    insert.bind(3, text.data(), static_cast<int>(text.size()));
    insert.exec();
    database.exec("INSERT INTO graphs VALUES ('a', 1, NULL)");
  }
  for (int i = 0; i < 2; ++i) {
    const auto store = opened(folder.path());
    CHECK(document(*store, "a") == text);
    CHECK(*store->names(sha256("file")));
    CHECK(store->fault()->empty());
  }
}
