#include <algorithm>
#include <catch2/catch.hpp>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/exit_codes.h"
#include "cli/terminal.h"
#include "geometry/json.h"
#include "tests/cli/program.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A toy graph with one parameter.
std::string graph(const Json& inputs) {
  return Json{{"format", 1},
              {"parameters", {{"reach", {{"type", "number"}}}}},
              {"nodes", {{"out", {{"inputs", inputs.is_null() ? Json::object() : inputs}}}}}}
      .dump();
}

}  // namespace

TEST_CASE("Wrong use is exit 2 and says how") {
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {},
           {"dance"},
           {"eval"},
           {"eval", "-", "--quality", "best"},
           {"eval", "-", "--deadline-ms", "0"},
           {"eval", "-", "--threads", "0"},
           {"eval", "-", "--set", "reach"},
           {"eval", "-", "-o", "-", "--report", "-"},
           {"eval", "-", "-o", ""},
           {"eval", "-", "--report", ""},
           {"eval", "-", "--instruction-set", "ABACUS"},
           {"nodes", "--json", "--markdown"},
           {"serve", "--port", "70000"},
           {"serve", "--host", "0.0.0.0", "--port", "0"},
           {"serve", "--port", "0", "--allow-origin", "site.example"},
           {"serve", "--port", "0", "--allow-origin", "https://site.example/"},
           {"serve", "--port", "0", "--allow-origin", "https://site.example; script-src *"},
           {"serve", "--port", "0", "--allow-origin", "*", "--token", "swordfish"},
           {"serve", "--host", "127.evil.example", "--port", "0"},
           {"serve", "--host", "localhost.evil.example", "--port", "0"},
       }) {
    const auto outcome = run_dini(words, graph({}));
    CAPTURE(outcome.err);
    CHECK(outcome.code == 2);
    CHECK_FALSE(outcome.err.empty());
    CHECK(outcome.out.empty());
  }
  CHECK(run_dini({"eval", "-", "--instruction-set", "ABACUS"}, graph({})).err.find("SCALAR") != std::string::npos);
  CHECK(run_dini({"--help"}).code == 0);
  CHECK(run_dini({"--version"}).code == 0);
}

TEST_CASE("Wrong use is said in one line that names what is wrong") {
  const auto said = [](const std::vector<std::string>& words) { return run_dini(words, graph({})).err; };
  CHECK(said({}) == "error: a command is needed; see dini --help [usage]\n");
  CHECK(said({"evl", "x.json"}) ==
        "error: there is no command 'evl'; did you mean \"eval\"?; see dini --help [usage]\n");
  CHECK(said({"eval", "-", "--sett", "a=1"}).find("--sett") != std::string::npos);
  CHECK(said({"inspect", "-", "out."}).find("NODE.OUTPUT") != std::string::npos);
  CHECK(said({"eval", "-", "--set", "reach=1", "--set", "reach=2"}) == "error: --set gives 'reach' twice [usage]\n");
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--bogus"},
                                                                                     {"eval"},
                                                                                     {"eval", "-", "--bogus"},
                                                                                     {"eval", "-", "--quality", "best"},
                                                                                     {"inspect", "-"},
                                                                                     {"inspect", "-", ""},
                                                                                     {"nodes", "more"},
                                                                                     {"serve", "--port", "x"},
                                                                                     {"serve", "--host", ""}}) {
    const std::string line = said(words);
    CAPTURE(line);
    CHECK(run_dini(words, graph({})).code == 2);
    CHECK(line.starts_with("error: "));
    CHECK(line.ends_with(" [usage]\n"));
    CHECK(std::count(line.begin(), line.end(), '\n') == 1);
  }
}

TEST_CASE("A document that cannot be read is named") {
  CHECK(run_dini({"eval", "-"}, "{").err.starts_with("standard input:1:2: error: the text is not JSON"));
  CHECK(run_dini({"validate", "/nowhere/graph.json"}).err ==
        "error: /nowhere/graph.json: No such file or directory [io]\n");
  const auto endless = run_dini({"eval", "/dev/zero"});
  CHECK(endless.code == 5);
  CHECK(endless.err == "error: /dev/zero: there are more than 64 MiB [limit-exceeded]\n");
  CHECK(run_dini({"serve", "--port", "0", "--examples", "/nowhere"}).code == 6);
}

TEST_CASE("Outputs replace files whole, go through links and into pipes, and never over the graph") {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("dini-outputs-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const auto path = [&](const char* name) { return (folder / name).string(); };
  std::ofstream(path("graph.json")) << graph({{"bytes", 5}});

  std::ofstream(path("old.glb")) << "something older and longer";
  fs::create_symlink(path("old.glb"), path("link.glb"));
  CHECK(run_dini({"eval", path("graph.json"), "-o", path("link.glb")}).code == 0);
  CHECK(fs::is_symlink(path("link.glb")));
  CHECK(fs::file_size(path("old.glb")) == 5);

  REQUIRE(::mkfifo(path("pipe").c_str(), 0600) == 0);
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  CHECK(run_dini({"eval", path("graph.json"), "-o", path("pipe")}).code == 0);
  char bytes[8];
  CHECK(::read(reader, bytes, sizeof bytes) == 5);
  ::close(reader);
  CHECK(fs::is_fifo(path("pipe")));

  const auto over = run_dini({"eval", path("graph.json"), "-o", path("graph.json"), "--format", "toy"});
  CHECK(over.code == 2);
  CHECK(over.err == "error: -o would write over " + path("graph.json") + ", which is read [usage]\n");
  std::ofstream(path("mesh.obj")) << "v 0 0 0";
  for (const auto* option : {"-o", "--report"}) {
    const auto asset = run_dini(
        {"eval", path("graph.json"), "--asset", "m=" + path("mesh.obj"), option, path("mesh.obj"), "--format", "toy"});
    CHECK(asset.code == 2);
    CHECK(asset.err.find("which is read") != std::string::npos);
  }
  CHECK(fs::file_size(path("mesh.obj")) == 7);
  CHECK(run_dini({"eval", path("graph.json"), "-o", path("a"), "--report", path("a")}).code == 2);
  CHECK(run_dini({"eval", path("graph.json"), "-o", folder.string()}).err ==
        "error: " + folder.string() + ": Is a directory [io]\n");
  CHECK(run_dini({"eval", path("graph.json"), "--report", path("none/r.json")}).code == 6);
  CHECK(run_dini({"eval", path("graph.json"), "-o", path("graph.json/x.glb")}).code == 6);
  CHECK(Json::parse(std::ifstream(path("graph.json")))["format"] == 1);
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 5);
  fs::remove_all(folder);
}

TEST_CASE("A model goes to standard output or to a file, the report beside it") {
  const auto outcome =
      run_dini({"eval", "-", "-o", "-", "--threads", "1", "--instruction-set", "SCALAR"}, graph({{"bytes", 3}}));
  CHECK(outcome.code == 0);
  CHECK(outcome.out == "ggg");

  CHECK(run_dini({"eval", "-"}, graph({{"bytes", 3}})).out == "out: 3 bytes\n");

  const auto file = std::filesystem::temp_directory_path() / "dini-eval-test.glb";
  const auto reported =
      run_dini({"eval", "-", "--set", "reach=2", "-o", file.string(), "--report", "-"}, graph({{"bytes", 4}}));
  CHECK(reported.code == 0);
  CHECK(Json::parse(reported.out)["model"]["bytes"] == 4);
  CHECK(std::filesystem::file_size(file) == 4);
  std::filesystem::remove(file);
}

TEST_CASE("A report is written however the run ends, and says how") {
  const auto file = std::filesystem::temp_directory_path() / ("dini-report-" + std::to_string(::getpid()));
  const auto report_of = [&](const std::string& document, int code, const std::vector<std::string>& more = {}) {
    std::ofstream(file) << R"({"succeeded": true, "of": "an earlier run"})";
    std::vector<std::string> words = {"eval", "-", "--report", file.string()};
    words.insert(words.end(), more.begin(), more.end());
    CHECK(run_dini(words, document).code == code);
    const Json report = Json::parse(std::ifstream(file), nullptr, false);
    CHECK_FALSE(report.contains("of"));
    return report;
  };
  CHECK(report_of(graph({{"bytes", 3}}), 0)["succeeded"] == true);
  CHECK(report_of(graph({{"bytes", 3}}), 0)["errors"].empty());
  for (const auto& [inputs, code, name] :
       std::vector<std::tuple<Json, int, std::string>>{{{{"problem", "check-failed"}}, 1, "check-failed"},
                                                       {{{"invalid", "out-of-range"}}, 3, "out-of-range"},
                                                       {{{"problem", "degenerate"}}, 4, "degenerate"},
                                                       {{{"memory", true}}, 5, "out-of-memory"},
                                                       {{{"throws", true}}, 70, "internal"}}) {
    const Json report = report_of(graph(inputs), code);
    CHECK(report["succeeded"] == false);
    REQUIRE(report["errors"].size() == 1);
    CHECK(report["errors"][0]["code"] == name);
    CHECK_FALSE(report.contains("model"));
  }
  CHECK(report_of("{", 3)["errors"][0]["code"] == "not-json");
  CHECK(report_of(graph({{"milliseconds", 60'000}}), 5, {"--deadline-ms", "20"})["errors"][0]["code"] == "deadline");
  CHECK(report_of(graph({{"bytes", 3}}), 6, {"-o", "/dev/full"})["succeeded"] == false);
  std::filesystem::remove(file);
}

TEST_CASE("Each way to fail has its exit code") {
  CHECK(run_dini({"eval", "-"}, "{").code == 3);
  CHECK(run_dini({"eval", "-"}, graph({{"invalid", "out-of-range"}})).code == 3);
  CHECK(run_dini({"eval", "-", "--set", "unknown=1"}, graph({})).code == 3);
  CHECK(run_dini({"eval", "-"}, graph({{"invalid", "limit-exceeded"}})).code == 5);
  CHECK(run_dini({"eval", "-"}, graph({{"problem", "degenerate"}})).code == 4);
  CHECK(run_dini({"eval", "-"}, graph({{"problem", "check-failed"}})).code == 1);
  CHECK(run_dini({"eval", "-", "--deadline-ms", "20"}, graph({{"milliseconds", 60'000}})).code == 5);
  CHECK(run_dini({"eval", "/nowhere/graph.json"}).code == 6);
  CHECK(run_dini({"eval", "/"}).code == 6);
  CHECK(run_dini({"eval", "-", "-o", "/nowhere/out.glb"}, graph({})).code == 6);
  CHECK(run_dini({"eval", "-"}, graph({{"throws", true}})).code == 70);
}

TEST_CASE("Problems are one line each, with code and place, harmless for the terminal") {
  CHECK(run_dini({"eval", "-"}, graph({{"invalid", "out-of-range"}})).err ==
        "standard input:1:29: error: out.amount: The toy was asked for 'out-of-range'. [out-of-range]\n");
  CHECK(run_dini({"eval", "-", "--set", "unknown=1"}, graph({})).err ==
        "standard input: error: --set unknown: There is no parameter 'unknown'. [unknown-parameter]\n");
  CHECK(dini::cli::printable("a\x1b]0;x\x07\xc2\x9b\xc3\xa9\x7f") == "a\\x1b]0;x\\x07\\x9b\xc3\xa9\\x7f");
}

TEST_CASE("Validation prints a verdict for people or for programs") {
  const auto good = run_dini({"validate", "-"}, graph({}));
  CHECK(good.code == 0);
  CHECK(good.out == "valid (8 bytes)\n");
  const auto wrong = run_dini({"validate", "-"}, graph({{"invalid", "type-mismatch"}}));
  CHECK(wrong.code == 3);
  CHECK(wrong.err ==
        "standard input:1:29: error: out.amount: The toy was asked for 'type-mismatch'. [type-mismatch]\n");
  CHECK(Json::parse(run_dini({"validate", "-", "--json"}, graph({})).out)["valid"] == true);
}

TEST_CASE("Inspection prints the value on a wire") {
  const auto outcome = run_dini({"inspect", "-", "out.asset", "--full"}, graph({}));
  CHECK(outcome.code == 0);
  CHECK(Json::parse(outcome.out)["type"] == "number");
  CHECK(run_dini({"inspect", "-", "nobody"}, graph({})).code == 3);
  CHECK(run_dini({"inspect", "-", "nobody"}, graph({{"invalid", "out-of-range"}})).code == 3);
}

TEST_CASE("The node types are listed in three ways") {
  CHECK(run_dini({"nodes"}).out.find("toy ") == 0);
  CHECK(Json::parse(run_dini({"nodes", "--json"}).out)["nodes"][0]["id"] == "toy");
  const std::string page = run_dini({"nodes", "--markdown"}).out;
  CHECK(page.find("## Toys\n\n[Toy](#toy-toy)\n\n### Toy (`toy`)\n\nWaits for a while.\n") != std::string::npos);
  CHECK(page.find("| `milliseconds` | integer | `0` |") != std::string::npos);
}

TEST_CASE("Settings are JSON when they parse and text otherwise") {
  CHECK(run_dini({"eval", "-", "--set", "reach=[1,2"}, graph({})).code == 0);
  CHECK(run_dini({"eval", "-", "--set", "reach="}, graph({})).code == 0);
  CHECK(run_dini({"eval", "-", "--set", "=1"}, graph({})).code == 2);
}

TEST_CASE("Files are given by name, and wrong ones end the program with the right code") {
  const auto folder = std::filesystem::temp_directory_path() / ("dini-assets-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto file = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return (folder / name).string();
  };
  const std::string good = file("good.obj", "v 0 0 0"), broken = file("broken.obj", "broken");
  const std::string large = file("large.obj", "large");
  const auto sparse = folder / "sparse.obj";
  std::ofstream(sparse).close();
  std::filesystem::resize_file(sparse, std::uintmax_t{1} << 40);
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"eval", "-"}, {"validate", "-"}, {"inspect", "-", "out"}}) {
    const auto code_of = [&](const std::vector<std::string>& assets) {
      std::vector<std::string> words = command;
      for (const std::string& asset : assets) words.insert(words.end(), {"--asset", asset});
      return run_dini(words, graph({})).code;
    };
    CAPTURE(command.front());
    CHECK(code_of({"a=" + good, "b.obj=" + good}) == 0);
    CHECK(code_of({good}) == 2);
    CHECK(code_of({"=" + good}) == 2);
    CHECK(code_of({"a="}) == 2);
    CHECK(code_of({"a=" + good, "a=" + good}) == 2);
    CHECK(code_of({"wrong name=" + good}) == 2);
    CHECK(code_of({"a=/nowhere/at/all.obj"}) == 6);
    CHECK(code_of({"a=" + folder.string()}) == 6);
    CHECK(code_of({"a=" + broken}) == 3);
    CHECK(code_of({"a=" + large}) == 5);
    CHECK(code_of({"a=" + sparse.string()}) == 5);
  }
  CHECK(run_dini({"eval", "-", "--asset", "a=" + broken}, graph({})).err ==
        "error: " + broken + ": The toy was given a broken file. [invalid-asset]\n");
  std::filesystem::remove_all(folder);
}
