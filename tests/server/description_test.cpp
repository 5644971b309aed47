// The description of the routes, asked for from a running server and held against what that server answers: every
// method at every address, every status, and every JSON answer against its schema.

#include "service/requests/description.h"

#include <algorithm>
#include <fstream>
#include <set>

#include "server/server_limits.h"
#include "service/problem_codes.h"
#include "tests/server/fixture.h"
#include "tests/support/json_schema.h"
#include "tests/support/troubled_engine.h"

using namespace dini;
using namespace dini::support;

namespace {

const std::string example_id = "fig04_boosted_ring";

/// One method of one address in the description.
struct Described {
  std::string method;
  std::string path;  ///< with its braces
  Json operation;

  bool is_head() const { return method == "HEAD"; }
  bool has_body() const { return operation.contains("requestBody"); }
  /// What the engine does for it can go wrong. What goes wrong with a variant of a sweep is in its line.
  bool is_worked_for() const { return has_body() && path != "/v1/sweeps" && method != "PUT"; }
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

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string with(std::string text, const std::string& what, const std::string& instead) {
  text.replace(text.find(what), what.size(), instead);
  return text;
}

/// The address with the examples of its parameters.
std::string address(const Described& described) {
  std::string path = described.path;
  for (const Json& parameter : described.operation.value("parameters", Json::array())) {
    if (parameter["in"] != "path") continue;
    path = with(path, "{" + parameter["name"].get<std::string>() + "}", parameter["example"]);
  }
  return path;
}

/// The request that the description gives as an example.
SentText example_request(const Described& described) {
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
void keep_example(int port) {
  const std::string body = example_graph().dump();
  ask(port, "PUT /v1/graphs/example HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n" +
                std::string("If-None-Match: *\r\nContent-Length: ") + std::to_string(body.size()) + "\r\n\r\n" + body);
}

std::optional<Answer> answer_to(int port, const Described& described, const SentText& sent) {
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
      Json& parameters = described.operation["parameters"];
      if (described.path.starts_with("/v1/artifacts/") && made->status == 200) {
        parameters[0]["example"] = made->lines().front()["model"]["sha256"];
      }
      if (described.path.starts_with("/v1/assets/") && !sent.empty()) parameters[0]["example"] = sent;
    }
  }

  Folder folder_;
  std::unique_ptr<RunningOver> running_;
  Json document_;
  std::vector<Described> all_;
};

/// Holds an answer against its description: headers, media type, and JSON against its schema.
void check_answer(const DescribedServer& server, const Described& described, const std::optional<Answer>& answer,
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
void check_problem(const DescribedServer& server, const Described& described, const std::optional<Answer>& answer,
                   int status) {
  check_answer(server, described, answer, status);
  if (described.is_head()) return;
  const Json& codes = described.operation["responses"][std::to_string(status)]["x-problem-codes"];
  const std::string code = answer->code();
  CAPTURE(described.method, described.path, code, codes);
  CHECK(std::ranges::find(codes, Json(code)) != codes.end());
}

/// What makes a request get each status that is decided from its text alone.
std::map<int, std::function<void(const Described&, SentText&)>> ways_to_be_refused() {
  const std::size_t longest = Limits{}.asset_bytes;
  return {{400, [](const Described&, SentText& sent) { sent.headers += "Bad Header\r\n"; }},
          {403, [](const Described&, SentText& sent) { sent.headers += "Origin: http://evil.example\r\n"; }},
          {404,
           [](const Described& described, SentText& sent) {
             sent.line =
                 described.method + " " + described.path.substr(0, described.path.find('{')) + "nothing HTTP/1.1";
           }},
          {406, [](const Described&, SentText& sent) { sent.headers += "Accept: text/html\r\n"; }},
          {411, [](const Described&, SentText& sent) { sent.length.clear(); }},
          {412,
           [](const Described&, SentText& sent) {
             sent.headers += "If-Match: \"none\"\r\n";
             if (sent.body.empty()) return;
             sent.body.replace(sent.body.size() - 1, 1, R"(,"meta":{"title":"another"}})");
             sent.length = "Content-Length: " + std::to_string(sent.body.size()) + "\r\n";
           }},
          {413, [longest](const Described&,
                          SentText& sent) { sent.length = "Content-Length: " + std::to_string(longest + 1) + "\r\n"; }},
          {414,
           [](const Described&, SentText& sent) {
             sent.line = with(sent.line, " HTTP", "?" + std::string(server::Settings{}.line_bytes, 'x') + " HTTP");
           }},
          {415, [](const Described&, SentText& sent) { sent.headers = "Content-Type: text/html\r\n"; }},
          {416, [](const Described&, SentText& sent) { sent.headers += "Range: bytes=99999999-\r\n"; }},
          {417, [](const Described&, SentText& sent) { sent.headers += "Expect: wonders\r\n"; }},
          {421, [](const Described&, SentText& sent) { sent.host = "evil.example"; }},
          {422,
           [](const Described& described, SentText& sent) {
             if (!described.has_body()) {
               sent.line = with(sent.line, " HTTP", "?nothing=1 HTTP");
               return;
             }
             sent.body = "{}";
             sent.length = "Content-Length: 2\r\n";
           }},
          {428, [](const Described&, SentText& sent) { sent.headers = "Content-Type: application/json\r\n"; }},
          {431,
           [](const Described&, SentText& sent) {
             sent.headers += "X-Long: " + std::string(server::Settings{}.line_bytes, 'x') + "\r\n";
           }},
          {505, [](const Described&, SentText& sent) { sent.line = with(sent.line, "HTTP/1.1", "HTTP/3.0"); }}};
}

bool may_answer(const Described& described, int status) {
  return described.operation["responses"].contains(std::to_string(status));
}

}  // namespace

TEST_CASE("Every route answers the example of its description with what the description says") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  for (const Described& described : server.all()) {
    const SentText sent = example_request(described);
    const int status = described.path == "/v1/assets" ? 201 : described.method == "DELETE" ? 204 : 200;
    const auto answer = answer_to(server.port(), described, sent);
    check_answer(server, described, answer, status);
    if (!may_answer(described, 304)) continue;
    SentText again = sent;
    again.headers += "If-None-Match: " + answer->header("etag") + "\r\n";
    check_answer(server, described, answer_to(server.port(), described, again), 304);
  }
}

TEST_CASE("A part of a file is answered as described") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  for (const Described& described : server.all()) {
    if (!may_answer(described, 206)) continue;
    SentText sent = example_request(described);
    sent.headers += "Range: bytes=4-7\r\n";
    const auto answer = answer_to(server.port(), described, sent);
    check_answer(server, described, answer, 206);
    CHECK(answer->body.size() == 4);
  }
}

TEST_CASE("Every media type of the description is taken and answered") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  for (const Described& described : server.all()) {
    if (described.is_head()) continue;
    for (const auto& [status, response] : described.operation["responses"].items()) {
      if (!status.starts_with('2') || status == "206") continue;
      if (!response.contains("content")) continue;
      for (const auto& [type, content] : response["content"].items()) {
        SentText sent = example_request(described);
        sent.headers += "Accept: " + type + "\r\n";
        if (described.method == "PUT" && status == "201") {
          ask(server.port(), "DELETE " + address(described) + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
        }
        const auto answer = answer_to(server.port(), described, sent);
        check_answer(server, described, answer, std::stoi(status));
        // What is kept has the type that it was made with.
        if (described.path != "/v1/artifacts/{sha256}") CHECK(answer->header("content-type").starts_with(type));
      }
    }
    if (!described.has_body()) continue;
    for (const auto& [type, content] : described.operation["requestBody"]["content"].items()) {
      SentText sent = example_request(described);
      sent.headers = "Content-Type: " + type + "\r\n" + described.condition();
      CHECK(answer_to(server.port(), described, sent)->status < 300);
    }
  }
}

TEST_CASE("Every status that a request can be refused with is a problem as described") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  for (const auto& [status, spoil] : ways_to_be_refused()) {
    for (const Described& described : server.all()) {
      if (!may_answer(described, status)) continue;
      // With its one page loaded, this server has everything at this address.
      if (status == 404 && described.path.find('{') == std::string::npos) continue;
      // For eyes: the page itself says what is wrong.
      if (status == 404 && described.path == "/embed/{id}") continue;
      SentText sent = example_request(described);
      spoil(described, sent);
      check_problem(server, described, answer_to(server.port(), described, sent), status);
    }
  }
}

TEST_CASE("A request that needs a token, or does not arrive, is a problem as described") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer open(trouble);
  auto settings = quick_settings();
  settings.token = "swordfish";
  const DescribedServer guarded(trouble, settings);
  std::vector<std::pair<const Described*, std::unique_ptr<Client>>> slow;
  for (const Described& described : open.all()) {
    if (may_answer(described, 401)) {
      const auto answer = answer_to(guarded.port(), described, example_request(described));
      check_problem(guarded, described, answer, 401);
    }
    slow.emplace_back(&described, std::make_unique<Client>(open.port()));
    slow.back().second->send(described.method + " " + described.path.substr(0, 1));
  }
  for (const auto& [described, client] : slow) {
    const auto answer = client->receive(described->is_head());
    check_problem(open, *described, answer, 408);
  }
}

TEST_CASE("Trouble of the engine is a problem as described, wherever the engine works") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  for (const auto& [kind, status] :
       {std::pair{Trouble::throws, 500}, {Trouble::no_memory, 503}, {Trouble::never_ends, 504}}) {
    trouble = kind;
    for (const Described& described : server.all()) {
      if (!described.is_worked_for()) continue;
      REQUIRE(may_answer(described, status));
      check_problem(server, described, answer_to(server.port(), described, example_request(described)), status);
    }
  }
}

TEST_CASE("A request that a newer one replaces is a problem as described") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  trouble = Trouble::never_ends;
  for (const Described& described : server.all()) {
    if (!may_answer(described, 409)) continue;
    SentText sent = example_request(described);
    sent.headers += "Supersede-Key: slider\r\n";
    Client older(server.port()), newer(server.port());
    older.send(sent.text());
    newer.send(sent.text());
    check_problem(server, described, older.receive(described.is_head()), 409);
  }
}

TEST_CASE("What there is no room for is a problem as described") {
  std::atomic<Trouble> trouble = Trouble::none;
  auto settings = quick_settings();
  const Folder folder("full");
  settings.data = folder.path();
  settings.store_bytes = 1 << 17;
  settings.asset_file_bytes = 1 << 16;
  const DescribedServer server(trouble, settings);
  for (const Described& described : server.all()) {
    if (!may_answer(described, 507)) continue;
    if (described.path == "/v1/assets") {
      SentText sent = example_request(described);
      sent.body += "# " + std::string(settings.asset_file_bytes, 'x');
      sent.length = "Content-Length: " + std::to_string(sent.body.size()) + "\r\n";
      check_problem(server, described, answer_to(server.port(), described, sent), 507);
    }
    if (described.method != "PUT") continue;
    Json large = example_graph();
    for (int i = 0; i < 10; ++i) large["meta"]["texts"].push_back(std::string(settings.store_bytes / 4, 'x'));
    SentText sent = example_request(described);
    sent.line = with(sent.line, "example", "large");
    sent.body = large.dump();
    sent.length = "Content-Length: " + std::to_string(sent.body.size()) + "\r\n";
    check_problem(server, described, answer_to(server.port(), described, sent), 507);
  }
}

TEST_CASE("Every status in the description is asked for by these tests") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  std::set<int> asked = {200, 201, 204, 206, 304, 401, 408, 409, 500, 503, 504, 507};
  for (const auto& [status, spoil] : ways_to_be_refused()) asked.insert(status);
  for (const Described& described : server.all()) {
    for (const auto& [status, response] : described.operation["responses"].items()) {
      CAPTURE(described.path, status);
      CHECK(asked.contains(std::stoi(status)));
    }
  }
}

TEST_CASE("Limits are described with the names and defaults that /version tells") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  const Json limits = get(server.port(), "/version")->json()["limits"];
  CHECK(limits.size() == evaluation_limits().size() + server::server_limits().size());
  CHECK(limits["body_bytes"] == Limits{}.body_bytes);
  CHECK(limits["interactive_milliseconds"] == 2'000);
  CHECK(limits["head_milliseconds"] == 500);
  CHECK(limits["compute_slots"] == 1);
}

TEST_CASE("The page about the interface holds every address, limit and code, and nothing that the policy forbids") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  const auto page = get(server.port(), "/docs");
  REQUIRE(page);
  for (const Described& described : server.all()) {
    CAPTURE(described.path);
    CHECK(page->body.find("<code>" + described.path + "</code>") != std::string::npos);
  }
  for (const auto& limit : evaluation_limits()) {
    CHECK(page->body.find("<code>" + flag_of(limit.name) + "</code>") != std::string::npos);
  }
  for (const ProblemCode& code : problem_codes()) {
    CAPTURE(code.code);
    const std::string own = "problems/" + std::string(code.code);
    CHECK(page->body.find("href=\"" + own + "\"") != std::string::npos);
    const auto about = get(server.port(), "/" + own);
    REQUIRE(about);
    CHECK(about->status == 200);
    CHECK(about->body.find("<code>" + std::string(code.code) + "</code>") != std::string::npos);
  }
  for (const std::string forbidden : {"<script", "<style", " style=", " onclick=", "http:", "https:"}) {
    CAPTURE(forbidden);
    CHECK(page->body.find(forbidden) == std::string::npos);
  }
}

TEST_CASE("The code of every problem has its page at the problem's type") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  const Json problem = post(server.port(), "/v1/evaluate", "{}")->json();
  CHECK(problem["type"] == "/problems/required-input-missing");
  CHECK(get(server.port(), problem["type"])->status == 200);
  for (const std::string none : {"no-such-code", "<script>", "..%2fdocs"}) {
    CHECK(get(server.port(), "/problems/" + none)->code() == "not-found");
  }
}
