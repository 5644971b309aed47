// Each limit of connections, requests, jobs and what is kept, set so low that it is met.

#include "server/server_limits.h"

#include <map>

#include "tests/server/fixture.h"
#include "tests/support/documents.h"

using namespace dini;
using namespace dini::support;

namespace {

using server::Settings;

/// Meets a limit on a server of these settings, and answers what is seen of it.
using Met = std::function<std::string(const Settings& settings)>;

std::string code_or_done(const std::optional<Answer>& answer) {
  if (!answer) return "closed";
  return answer->status < 300 ? "done" : answer->code();
}

/// One request, whose answer tells all.
Met asking(const std::function<std::string()>& bytes) {
  return [bytes](const Settings& settings) {
    const Running server(settings);
    return code_or_done(ask(server.port(), bytes()));
  };
}

std::string get_with(const std::string& headers) {
  return "GET /v1/nodes HTTP/1.1\r\nHost: localhost\r\n" + headers + "\r\n";
}

std::string half_a_body() { return "POST /v1/evaluate HTTP/1.1\r\nHost: localhost\r\nContent-Length: 10\r\n\r\nabc"; }

/// What becomes of a connection between two requests.
std::string idle(const Settings& settings) {
  const Running server(settings);
  Client client(server.port());
  client.send(get_with(""));
  REQUIRE(client.receive());
  return client.closed() ? "closed" : "open";
}

std::string crowded(const Settings& settings) {
  const Running server(settings);
  Client first(server.port());
  first.send(get_with(""));
  REQUIRE(first.receive());
  REQUIRE(get(server.port(), "/healthz"));
  first.send(get_with(""));
  return first.receive() ? "open" : "closed";
}

/// How many threads a server has that are not there with one thread for answers.
std::string threads(const Settings& settings) {
  auto one = settings;
  one.answer_threads = 1;
  std::size_t least = 0;
  {
    const Running server(one);
    least = thread_count();
  }
  const Running server(settings);
  return std::to_string(thread_count() - least);
}

/// So many long evaluations, each another one. Those that may run do so before the next is sent, since until then they
/// wait, and the next one might find no room.
std::vector<std::unique_ptr<Client>> busy_clients(int port, std::size_t count, std::size_t may_run) {
  std::vector<std::unique_ptr<Client>> clients;
  const std::size_t before = toy::counters().started;
  for (std::size_t i = 0; i < count; ++i) {
    clients.push_back(std::make_unique<Client>(port));
    clients.back()->send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}, {"bytes", i}})));
    if (i < may_run) REQUIRE(eventually([&] { return toy::counters().started - before == i + 1; }));
  }
  return clients;
}

bool is_full(int port) { return get(port, "/readyz")->status == 503; }

/// Whether of three as many run as may, when the queue behind them is full.
std::string running(const Settings& settings) {
  const Running server(settings);
  const std::size_t before = toy::counters().started;
  const auto clients = busy_clients(server.port(), 3, settings.compute_slots);
  REQUIRE(eventually([&] { return is_full(server.port()); }));
  const auto all_run = [&] { return toy::counters().started - before == settings.compute_slots; };
  return eventually(all_run) ? "so many" : "others";
}

/// What another evaluation is told when one runs and one waits.
std::string waiting(const Settings& settings) {
  const Running server(settings);
  const auto clients = busy_clients(server.port(), 2, settings.compute_slots);
  REQUIRE(eventually([&] { return is_full(server.port()); }));
  return code_or_done(post(server.port(), "/v1/evaluate", toy_body({{"milliseconds", 60'001}})));
}

/// The number of a name in /metrics.
int metric(int port, const std::string& name) {
  const std::string text = "\n" + get(port, "/metrics")->body;
  const auto at = text.find("\n" + name + " ");
  REQUIRE(at != std::string::npos);
  return std::stoi(text.substr(at + name.size() + 2));
}

std::string begin(int port, int milliseconds) {
  const auto begun = post(port, "/v1/jobs", toy_body({{"milliseconds", milliseconds}}));
  return begun->status == 202 ? begun->json()["address"].get<std::string>() : begun->code();
}

std::string jobs_running(const Settings& settings) {
  auto wide = settings;
  wide.compute_slots = 4;
  const Running server(wide);
  for (int i = 0; i < 4; ++i) begin(server.port(), 60'000 + i);
  const auto all_settled = [&] {
    return metric(server.port(), "dini_jobs_running") == static_cast<int>(wide.jobs_at_once) &&
           metric(server.port(), "dini_jobs_waiting") == 4 - static_cast<int>(wide.jobs_at_once);
  };
  return eventually(all_settled) ? "so many" : "others";
}

std::string jobs_waiting(const Settings& settings) {
  const Running server(settings);
  begin(server.port(), 60'000);
  REQUIRE(eventually([&] { return metric(server.port(), "dini_jobs_running") == 1; }));
  begin(server.port(), 60'001);
  return begin(server.port(), 60'002);
}

/// The state that a job comes to, and why.
Met job(int milliseconds, const std::string& state) {
  return [milliseconds, state](const Settings& settings) {
    const Running server(settings);
    const std::string address = begin(server.port(), milliseconds);
    const auto told = [&] { return get(server.port(), address)->json(); };
    return eventually([&] { return told().value("state", "gone") == state; }) ? state : "other";
  };
}

/// How often one request that is sent twice is checked.
std::string checked(const Settings& settings) {
  const Running server(settings);
  const std::size_t before = toy::counters().prepared;
  for (int i = 0; i < 2; ++i) REQUIRE(post(server.port(), "/v1/evaluate", toy_body({{"bytes", 3}}))->status == 200);
  return std::to_string(toy::counters().prepared - before);
}

/// Whether the file of a sweep can be fetched by its hash.
std::string fetched(const Settings& settings) {
  const RunningReal server(settings);
  Json graph = document({{"a", make("sphere_mesh", {{"radius", {{"parameter", "r"}}}})},
                         {"out", make("export", {{"model", from("a")}})}});
  graph["parameters"] = {{"r", {{"type", "number"}, {"default", 1}}}};
  const auto answer = post(server.port(), "/v1/sweeps", Json{{"graph", graph}, {"list", {{{"r", 2}}}}}.dump());
  REQUIRE(answer->status == 200);
  return code_or_done(get(server.port(), answer->lines().front()["model"]["address"]));
}

std::string kept(const Settings& settings) {
  const Running server(settings);
  const std::string graph = document({{"a", make("toy")}}).dump() + std::string(100'000, ' ');
  return code_or_done(
      ask(server.port(),
          "PUT /v1/graphs/a HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nIf-None-Match: *\r\n"
          "Content-Length: " +
              std::to_string(graph.size()) + "\r\n\r\n" + graph));
}

std::string kept_file(const Settings& settings) {
  const Folder folder;
  auto with_data = settings;
  with_data.data = folder.path() / "data";
  const RunningReal server(with_data);
  const std::string file = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n# " + std::string(100'000, 'x');
  return code_or_done(
      ask(server.port(), "POST /v1/assets HTTP/1.1\r\nHost: localhost\r\nContent-Type: model/obj\r\nContent-Length: " +
                             std::to_string(file.size()) + "\r\n\r\n" + file));
}

/// What the second of two wrong tokens is told.
std::string guessed(const Settings& settings) {
  auto guarded = settings;
  guarded.token = "swordfish";
  const Running server(guarded);
  const auto guess = [&] { return get(server.port(), "/v1/nodes", "Authorization: Bearer a\r\n"); };
  guess();
  return code_or_done(guess());
}

constexpr std::size_t large = 50'000'000;

/// How a large answer comes, to a client that takes it or does not.
Met taking(bool takes) {
  return [takes](const Settings& settings) {
    Running server(settings);
    Client client(server.port());
    client.send(post_text("/v1/evaluate", toy_body({{"bytes", large}})));
    if (takes) return std::string(client.rest().size() > large ? "whole" : "cut");
    const auto is_logged = [&] { return server.log().find("/v1/evaluate 200") != std::string::npos; };
    REQUIRE(eventually(is_logged));
    return std::string(client.rest().size() > large ? "whole" : "cut");
  };
}

/// What one who runs when the server stops is told.
std::string drained(const Settings& settings) {
  Running server(settings);
  const std::size_t before = toy::counters().started;
  Client client(server.port());
  client.send(post_text("/v1/evaluate", toy_body({{"milliseconds", 60'000}, {"bytes", 1}})));
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  server.stop();
  return code_or_done(client.receive());
}

/// Whether the queue is full of two evaluations, of which one waits for memory beside a free place.
std::string in_memory(const Settings& settings) {
  auto two = settings;
  two.compute_slots = 2;
  const Running server(two);
  const std::size_t before = toy::counters().started;
  const auto clients = busy_clients(server.port(), 2, settings.compute_slots);
  const auto one_waits = [&] { return is_full(server.port()) && toy::counters().started == before + 1; };
  return eventually(one_waits) ? "one waits" : "both run";
}

struct ServerRow {
  std::uint64_t value;
  Met met;
  std::string expected;
};

std::map<std::string, ServerRow> server_rows() {
  return {
      {"connections", {1, crowded, "closed"}},
      {"answer_threads", {9, threads, "8"}},
      {"compute_slots", {2, running, "so many"}},
      {"compute_queue", {1, waiting, "busy"}},
      {"compute_bytes", {1, in_memory, "one waits"}},
      {"known_bytes", {0, checked, "2"}},
      {"artifact_bytes", {0, fetched, "not-found"}},
      {"store_bytes", {1 << 16, kept, "storage-full"}},
      {"asset_file_bytes", {1 << 16, kept_file, "storage-full"}},
      {"jobs_at_once", {2, jobs_running, "so many"}},
      {"jobs_waiting", {1, jobs_waiting, "busy"}},
      {"job_milliseconds", {50, job(60'000, "failed"), "failed"}},
      {"job_result_milliseconds", {1000, job(1, "expired"), "expired"}},
      {"head_bytes",
       {256, asking([] { return get_with("A: " + std::string(300, 'a') + "\r\n"); }), "headers-too-large"}},
      {"line_bytes",
       {128, asking([] { return get_with("A: " + std::string(200, 'a') + "\r\n"); }), "headers-too-large"}},
      {"header_count", {2, asking([] { return get_with("A: a\r\nB: b\r\n"); }), "headers-too-large"}},
      {"wrong_tokens", {1, guessed, "too-many-wrong-tokens"}},
      {"incoming_bytes",
       {1000, asking([] {
          return post_text("/v1/evaluate", toy_body({{"bytes", 1}}) + std::string(2000, ' '));
        }),
        "busy"}},
      {"unsent_bytes",
       {10, asking([] {
          return post_text("/v1/validate", toy_body({{"bytes", 1}}));
        }),
        "busy"}},
      {"head_milliseconds", {50, asking([] { return std::string("GET / HTTP/1.1\r\nX: "); }), "request-timeout"}},
      {"body_milliseconds", {50, asking(half_a_body), "request-timeout"}},
      {"idle_milliseconds", {100, idle, "closed"}},
      {"write_milliseconds", {200, taking(false), "cut"}},
      {"write_rate", {std::uint64_t{1} << 40, taking(true), "cut"}},
      {"drain_milliseconds", {10, drained, "shutting-down"}},
  };
}

}  // namespace

TEST_CASE("Every limit of connections, requests, jobs and what is kept is met where it is set") {
  const auto table = server_rows();
  CHECK(table.size() == server::server_limits().size());
  for (const Limit<Settings>& limit : server::server_limits()) {
    const std::string name(limit.name);
    CAPTURE(name);
    const auto row = table.find(name);
    REQUIRE(row != table.end());
    Settings settings = quick_settings();
    if (name == "write_rate") settings.write_deadline = std::chrono::milliseconds(1);
    limit.set(settings, row->second.value);
    CHECK(row->second.met(settings) == row->second.expected);
  }
}
