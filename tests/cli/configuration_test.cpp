#include <catch2/catch.hpp>
#include <sstream>

#include "server/server_limits.h"
#include "tests/cli/program.h"
#include "tests/cli/variable.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A configuration file of that text.
class ConfigurationFile {
 public:
  explicit ConfigurationFile(const std::string& text) { folder_.write("dini.toml", text); }
  std::string path() const { return (folder_.path() / "dini.toml").string(); }

 private:
  Folder folder_;
};

/// What the settings are with that file and those words.
Outcome printed(const std::string& file, std::vector<std::string> words = {}) {
  words.insert(words.begin(), {"serve", "--print-config"});
  if (!file.empty()) words.insert(words.end(), {"--config", file});
  return run_dini(words);
}

bool tells(const Outcome& outcome, const std::string& line) {
  return ("\n" + outcome.out).find("\n" + line) != std::string::npos;
}

/// Without what tells where each value comes from.
std::string values_of(const std::string& text) {
  std::istringstream lines(text);
  std::string values, line;
  while (std::getline(lines, line)) {
    if (!line.starts_with('#') && !line.empty()) values += line.substr(0, line.find("  # ")) + "\n";
  }
  return values;
}

}  // namespace

TEST_CASE("A flag wins over the environment, which wins over the file, which wins over the default") {
  const ConfigurationFile file("nodes = 5\nlinks = 6\njson_depth = 7\nhost = '127.0.0.2'\n");
  const Variable links("DINI_LINKS", "16"), depth("DINI_JSON_DEPTH", "17"), port("DINI_PORT", "1234");
  const Outcome outcome = printed(file.path(), {"--json-depth", "27"});
  CHECK(outcome.code == 0);
  CHECK(tells(outcome, "nodes = 5  # from " + file.path()));
  CHECK(tells(outcome, "links = 16  # from DINI_LINKS"));
  CHECK(tells(outcome, "json_depth = 27  # from --json-depth"));
  CHECK(tells(outcome, "samples = " + std::to_string(dini::Limits{}.samples) + "  # default"));
  CHECK(tells(outcome, "host = \"127.0.0.2\"  # from "));
  CHECK(tells(outcome, "port = 1234  # from DINI_PORT"));
}

TEST_CASE("What --print-config prints says the same when it is read") {
  const Outcome first = printed("", {"--nodes", "9", "--allow-host", "a.example:8443", "--allow-host", "b.example",
                                     "--port", "0", "--examples", "/tmp", "--web", "a \"b\\c\x7f", "--threads", "3"});
  REQUIRE(first.code == 0);
  CHECK(tells(first, "allow_host = [\"a.example:8443\", \"b.example\"]  # from --allow-host"));
  const ConfigurationFile file(first.out);
  const Outcome second = printed(file.path());
  CHECK(second.code == 0);
  CHECK(values_of(second.out) == values_of(first.out));
  CHECK(tells(second, "nodes = 9  # from "));
}

TEST_CASE("Every limit is printed with its unit") {
  const Outcome outcome = printed("");
  REQUIRE(outcome.code == 0);
  const auto look = [&](const auto& limit, std::uint64_t usual) {
    INFO(limit.name);
    CHECK(tells(outcome, std::string(limit.name) + " = " + std::to_string(usual) + "  # default"));
    CHECK(tells(outcome, "# " + std::string(limit.unit) + " "));
  };
  for (const auto& limit : dini::evaluation_limits()) look(limit, limit.get(dini::Limits{}));
  for (const auto& limit : dini::server::server_limits()) look(limit, limit.get(dini::server::Settings{}));
  CHECK(tells(outcome, "# allow_host is not set"));
}

TEST_CASE("A token is taken from everywhere and never shown") {
  const ConfigurationFile file("token = 'swordfish'");
  const Outcome from_file = printed(file.path());
  CHECK(from_file.code == 0);
  CHECK(tells(from_file, "# token is set, and not shown; from " + file.path()));
  CHECK(from_file.out.find("swordfish") == std::string::npos);
  const Variable token("DINI_TOKEN", "swordfish");
  const Outcome from_environment = printed("", {"--host", "0.0.0.0"});
  CHECK(tells(from_environment, "# token is set, and not shown; from DINI_TOKEN"));
  CHECK(from_environment.out.find("swordfish") == std::string::npos);
}

TEST_CASE("A list in the environment is separated by commas") {
  const Variable hosts("DINI_ALLOW_HOST", "a.example,b.example:80");
  CHECK(tells(printed(""), "allow_host = [\"a.example\", \"b.example:80\"]  # from DINI_ALLOW_HOST"));
}

TEST_CASE("The environment names the file too") {
  const ConfigurationFile file("nodes = 5");
  const Variable config("DINI_CONFIG", file.path());
  CHECK(tells(printed(""), "nodes = 5  # from " + file.path()));
}

TEST_CASE("What is wrong in the file is told by file, line and setting") {
  const auto [text, line] = GENERATE(table<std::string, std::string>({
      {"\nbody_byte = 1", ":2: there is no setting 'body_byte'; did you mean \"body_bytes\"?"},
      {"config = 'other'", ":1: there is no setting 'config'"},
      {"nodes = '5'", ":1: nodes: needs a whole number"},
      {"nodes = 1.5", ":1: nodes: needs a whole number"},
      {"nodes = true", ":1: nodes: needs a whole number"},
      {"nodes = 0", ":1: nodes: "},
      {"nodes = -1", ":1: nodes: "},
      {"port = 65536", ":1: port: "},
      {"host = 1", ":1: host: needs a text in quotes"},
      {"allow_host = ['a', 1]", ":1: allow_host: needs a list of texts"},
      {"log_level = 'loud'", ":1: log_level: "},
      {"[nodes]\nmost = 1", ":1: nodes: needs a whole number"},
      {"nodes = 1\nnodes = 2", ":2: "},
      {"nodes 5", ":1: "},
      {"host = \"\\u0000\nx", ":1: "},
  }));
  INFO(text);
  const ConfigurationFile file(text);
  const Outcome outcome = printed(file.path());
  CHECK(outcome.code == 2);
  CHECK(outcome.err.starts_with("error: " + file.path() + line));
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
  CHECK(outcome.out.empty());
}

TEST_CASE("What is wrong in the file is told also where it is not needed, and all of it at once") {
  const ConfigurationFile file("nodes = 0\nlinks = 'x'\n");
  const Outcome outcome = printed(file.path(), {"--nodes", "5", "--links", "6"});
  CHECK(outcome.code == 2);
  CHECK(std::ranges::count(outcome.err, '\n') == 2);
}

TEST_CASE("A file of settings that cannot be read is told") {
  CHECK(printed("/nowhere/dini.toml").code == 6);
  CHECK(printed("/tmp").code == 6);
  CHECK(printed("/dev/zero").code != 0);
}
