#pragma once

// The description of the routes, asked for from a running server, and what holds that server's answers against it.

#include <algorithm>
#include <fstream>

#include "service/requests/description.h"
#include "tests/server/fixture.h"
#include "tests/support/json_schema.h"
#include "tests/support/troubled_engine.h"

namespace dini::support {

inline const std::string example_id = "fig04_boosted_ring";

/// One method of one address in the description.
struct Described {
  std::string method;
  std::string path;  ///< with its braces
  Json operation;

  bool is_head() const { return method == "HEAD"; }
  bool has_body() const { return operation.contains("requestBody"); }
  /// What the engine does for it can go wrong. What goes wrong with a variant of a sweep is in its line, a job is
  /// answered before it is done, and an explanation before anything is.
  bool is_worked_for() const {
    return has_body() && method != "PUT" && path != "/v1/sweeps" && path != "/v1/jobs" && path != "/v1/fit" &&
           path != "/v1/explain";
  }
  bool is_of_job() const { return path.starts_with("/v1/jobs/"); }
  /// Its answer when all is well.
  int usual_status() const {
    if (path == "/v1/assets") return 201;
    if (path == "/v1/jobs" || path == "/v1/fit") return 202;
    return method == "DELETE" ? 204 : 200;
  }
  bool is_of_graph() const { return path.starts_with("/v1/graphs/"); }
  /// What a write has to say of what it replaces.
  std::string condition() const { return method == "PUT" ? "If-None-Match: *\r\n" : ""; }
};

/// A request as it is sent; a test changes what it wants to be wrong.
struct SentText {
  std::string line;
  std::string host = "localhost";
  std::string length = {};
  std::string headers = {};
  std::string body = {};

  std::string text() const { return line + "\r\nHost: " + host + "\r\n" + length + headers + "\r\n" + body; }
};

inline std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

inline std::string with(std::string text, const std::string& what, const std::string& instead) {
  text.replace(text.find(what), what.size(), instead);
  return text;
}

/// The address with the examples of its parameters.
inline std::string address(const Described& described) {
  std::string path = described.path;
  for (const Json& parameter : described.operation.value("parameters", Json::array())) {
    if (parameter["in"] != "path") continue;
    path = with(path, "{" + parameter["name"].get<std::string>() + "}", parameter["example"]);
  }
  return path;
}

/// The same about another thing than that of the example.
inline Described about(Described described, const std::string& name) {
  for (Json& parameter : described.operation["parameters"]) {
    if (parameter["in"] == "path") {
      parameter["example"] = name;
      break;
    }
  }
  return described;
}

/// The request that the description gives as an example.
inline SentText example_request(const Described& described) {
  SentText sent{.line = described.method + " " + address(described) + " HTTP/1.1"};
  if (!described.has_body()) return sent;
  const Json& contents = described.operation["requestBody"]["content"];
  const auto content = contents.begin();
  sent.body = content->contains("example") ? (*content)["example"].dump() : "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  sent.headers = "Content-Type: " + content.key() + "\r\n" + described.condition();
  sent.length = "Content-Length: " + std::to_string(sent.body.size()) + "\r\n";
  return sent;
}

/// Keeps the graph that the addresses of the description are about, or leaves it as it is.
inline void keep_example(int port) {
  const std::string body = example_graph().dump();
  ask(port, "PUT /v1/graphs/example HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n" +
                std::string("If-None-Match: *\r\nContent-Length: ") + std::to_string(body.size()) + "\r\n\r\n" + body);
}

inline std::optional<Answer> answer_to(int port, const Described& described, const SentText& sent) {
  if (described.is_of_graph() && described.method != "PUT") keep_example(port);
  Client client(port);
  client.send(sent.text());
  return client.receive(described.is_head());
}

/// A server over the real engine with a page, an example and its picture.
class DescribedServer {
 public:
  explicit DescribedServer(std::atomic<Trouble>& trouble, server::Settings settings = quick_settings()) {
    folder_.write("web/index.html", "<html>");
    folder_.write("web/embed/index.html", "<html>");
    std::ifstream graph(std::string(DINI_EXAMPLES) + "/" + example_id + ".json");
    folder_.write("examples/" + example_id + ".json", {std::istreambuf_iterator<char>(graph), {}});
    folder_.write("examples/images/" + example_id + ".png", "picture");
    settings.web = folder_.path() / "web";
    settings.examples = folder_.path() / "examples";
    settings.compute_queue = 4;
    Limits limits;
    limits.interactive_milliseconds = 2'000;
    running_ = std::make_unique<RunningOver>(std::make_unique<TroubledEngine>(limits, trouble), settings);
    document_ = get(port(), "/openapi.json")->json();
    for (const auto& [path, methods] : document_["paths"].items()) {
      for (const auto& [method, operation] : methods.items()) all_.push_back({upper(method), path, operation});
    }
    name_files();
    name_job();
    keep_example(port());
  }

  int port() const { return running_->port(); }
  const Json& document() const { return document_; }
  const std::vector<Described>& all() const { return all_; }

 private:
  /// Files have no address before they are made or sent: the first one of the example of a sweep stands for all that
  /// are made, the example of an upload for all that are sent.
  void name_files() {
    const Json sweep = document_["paths"]["/v1/sweeps"]["post"]["requestBody"]["content"]["application/json"];
    const auto made = post(port(), "/v1/sweeps", sweep["example"].dump());
    std::string sent;
    for (const Described& described : all_) {
      if (described.path != "/v1/assets" || !described.has_body()) continue;
      const auto added = ask(port(), example_request(described).text());
      if (added->status == 201) sent = added->json()["sha256"];
    }
    for (Described& described : all_) {
      if (described.path.starts_with("/v1/artifacts/") && made->status == 200) {
        described = about(described, made->lines().front()["model"]["sha256"]);
      }
      if (described.path.starts_with("/v1/assets/") && !sent.empty()) described = about(described, sent);
    }
  }

  /// Nor have jobs: one that has ended stands for all.
  void name_job() {
    const auto begun = post(port(), "/v1/jobs", Json{{"graph", example_graph()}}.dump());
    if (begun->status != 202) return;
    const Json job = begun->json();
    for (Described& described : all_) {
      if (described.is_of_job()) described = about(described, job["id"]);
    }
    eventually([&] { return get(port(), job["address"])->json()["state"] == "succeeded"; });
  }

  Folder folder_;
  std::unique_ptr<RunningOver> running_;
  Json document_;
  std::vector<Described> all_;
};

/// Holds an answer against its description: headers, media type, and JSON against its schema.
inline void check_answer(const DescribedServer& server, const Described& described, const std::optional<Answer>& answer,
                         int status) {
  CAPTURE(described.method, described.path, status);
  REQUIRE(answer);
  CAPTURE(answer->body.substr(0, 500));
  REQUIRE(answer->status == status);
  const Json& response = described.operation["responses"].at(std::to_string(status));
  for (const auto& [name, header] : response["headers"].items()) {
    std::string lower = name;
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    CAPTURE(name);
    // A file has a name to be saved under, a report has none.
    if (name != "Content-Disposition") CHECK_FALSE(answer->header(lower).empty());
  }
  if (described.is_head() || !response.contains("content")) {
    CHECK(answer->body.empty());
    return;
  }
  const std::string type = answer->header("content-type");
  const std::string bare = type.substr(0, type.find(';'));
  REQUIRE(response["content"].contains(bare));
  const Json& content = response["content"][bare];
  CHECK_FALSE(answer->body.empty());
  if (!content.contains("schema")) return;
  if (bare == "application/x-ndjson") {
    for (const Json& line : answer->lines()) {
      CHECK(support::departures(line, content["schema"], server.document()) == std::vector<std::string>{});
    }
    return;
  }
  CHECK(support::departures(answer->json(), content["schema"], server.document()) == std::vector<std::string>{});
}

/// A problem with one of the codes that the description lists for its status.
inline void check_problem(const DescribedServer& server, const Described& described,
                          const std::optional<Answer>& answer, int status) {
  check_answer(server, described, answer, status);
  if (described.is_head()) return;
  const Json& codes = described.operation["responses"][std::to_string(status)]["x-problem-codes"];
  const std::string code = answer->code();
  CAPTURE(described.method, described.path, code, codes);
  CHECK(std::ranges::find(codes, Json(code)) != codes.end());
}

}  // namespace dini::support
