// Every method at every address, every status, and every JSON answer of a running server, held against the description
// that it gives of itself.

#include <set>

#include "server/server_limits.h"
#include "service/problem_codes.h"
#include "tests/server/described_server.h"

using namespace dini;
using namespace dini::support;

namespace {

/// What makes a request get each status that is decided from its text alone.
std::map<int, std::function<void(const Described&, SentText&)>> ways_to_be_refused() {
  const std::size_t longest = Limits{}.asset_bytes;
  return {
      {400, [](const Described&, SentText& sent) { sent.headers += "Bad Header\r\n"; }},
      {403, [](const Described&,
               SentText& sent) { sent.headers += "Origin: http://evil.example\r\nSec-Fetch-Site: cross-site\r\n"; }},
      {404,
       [](const Described& described, SentText& sent) {
         sent.line = described.method + " " + address(about(described, "nothing")) + " HTTP/1.1";
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

/// Whether a status of the description may have this code.
bool may_be(const Described& described, int status, const std::string& code) {
  if (!may_answer(described, status)) return false;
  const Json& codes = described.operation["responses"][std::to_string(status)]["x-problem-codes"];
  return std::ranges::find(codes, Json(code)) != codes.end();
}

}  // namespace

TEST_CASE("Every route answers the example of its description with what the description says") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  for (const Described& described : server.all()) {
    const SentText sent = example_request(described);
    const auto answer = answer_to(server.port(), described, sent);
    check_answer(server, described, answer, described.usual_status());
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
        if (status == "202") sent.headers += "Prefer: respond-async\r\n";
        // What is kept has the type that it was made with.
        if (described.path.ends_with("/result") && answer_to(server.port(), described, sent)->status == 406) continue;
        if (described.method == "PUT" && status == "201") {
          ask(server.port(), "DELETE " + address(described) + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
        }
        const auto answer = answer_to(server.port(), described, sent);
        // A drawing holds curves, and the model of the examples has none.
        if (type == "image/svg+xml" && answer->status == 422) {
          CHECK(answer->json()["errors"][0]["code"] == "nothing-to-export");
          continue;
        }
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

TEST_CASE("A request that needs a token, has wrong ones too often, or does not arrive, is a problem as described") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer open(trouble);
  auto settings = quick_settings();
  settings.token = "swordfish";
  settings.wrong_tokens = 1;
  const DescribedServer guarded(trouble, settings);
  std::vector<std::pair<const Described*, std::unique_ptr<Client>>> slow;
  for (const Described& described : open.all()) {
    if (may_answer(described, 401)) {
      const auto answer = answer_to(guarded.port(), described, example_request(described));
      check_problem(guarded, described, answer, 401);
    }
    if (may_answer(described, 429)) {
      SentText wrong = example_request(described);
      wrong.headers += "Authorization: Bearer tunafish\r\n";
      // Two of them are one more than may be sent in a minute; later ones are refused at once.
      answer_to(guarded.port(), described, wrong);
      const auto answer = answer_to(guarded.port(), described, wrong);
      check_problem(guarded, described, answer, 429);
      CHECK(std::stoi(answer->header("retry-after")) > 0);
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
    if (!may_be(described, 409, "superseded")) continue;
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

TEST_CASE("What came of no job is a problem as described") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  trouble = Trouble::never_ends;
  const Json job = post(server.port(), "/v1/jobs", Json{{"graph", example_graph()}}.dump())->json();
  const auto check_result = [&](const std::string& code) {
    for (const Described& described : server.all()) {
      if (!described.path.ends_with("/result") || !may_be(described, 409, code)) continue;
      const Described other = about(described, job["id"]);
      check_problem(server, other, answer_to(server.port(), other, example_request(other)), 409);
    }
  };
  check_result("job-unfinished");
  post(server.port(), job["address"].get<std::string>() + "/cancel", "");
  REQUIRE(eventually([&] { return get(server.port(), job["address"])->json()["state"] == "canceled"; }));
  check_result("canceled");
}

TEST_CASE("What came of a job long ago is a problem as described") {
  std::atomic<Trouble> trouble = Trouble::none;
  auto settings = quick_settings();
  settings.job_result_time = std::chrono::milliseconds(4'000);
  const DescribedServer server(trouble, settings);
  for (const Described& described : server.all()) {
    if (!may_answer(described, 410)) continue;
    const SentText sent = example_request(described);
    REQUIRE(eventually([&] { return answer_to(server.port(), described, sent)->status == 410; }));
    check_problem(server, described, answer_to(server.port(), described, sent), 410);
  }
}

TEST_CASE("Every status in the description is asked for by these tests") {
  std::atomic<Trouble> trouble = Trouble::none;
  const DescribedServer server(trouble);
  std::set<int> asked = {200, 201, 202, 204, 206, 304, 401, 408, 409, 410, 429, 500, 503, 504, 507};
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
