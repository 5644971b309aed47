#include "server/server.h"

#include <algorithm>
#include <spdlog/spdlog.h>
#include <system_error>
#include <thread>

#include "jobs/local_sweep.h"
#include "jobs/process_memory.h"
#include "server/addresses.h"
#include "server/base_path.h"
#include "server/connections.h"
#include "server/docs_page.h"
#include "server/metrics.h"
#include "server/openapi.h"
#include "server/request_log.h"
#include "server/routes.h"
#include "server/text.h"
#include "server/wrong_tokens.h"
#include "service/document_schema.h"
#include "store/asset_files.h"

namespace dini::server {
namespace {

/// Nanoseconds that everybody may wait for a place to compute, however many they are.
constexpr std::size_t short_wait = 1'000'000'000;

/// What stopped requests get to send their last answer.
constexpr std::chrono::seconds farewell{2};

std::size_t cores() { return std::max(1u, std::thread::hardware_concurrency()); }

jobs::JobRunner::Terms job_terms(const Settings& settings) {
  return {.at_once = settings.jobs_at_once,
          .most_waiting = settings.jobs_waiting,
          .deadline = settings.job_deadline,
          .result_time = settings.job_result_time};
}

/// The settings with what is left open decided for this machine.
Settings decided(Settings settings) {
  if (settings.answer_threads == 0) settings.answer_threads = std::max<std::size_t>(4, 2 * cores());
  if (settings.compute_slots == 0) settings.compute_slots = cores();
  if (settings.compute_queue == 0) settings.compute_queue = 16 * settings.compute_slots;
  if (settings.jobs_at_once == 0) settings.jobs_at_once = std::max<std::size_t>(2, settings.compute_slots) - 1;
  if (settings.compute_bytes == 0) settings.compute_bytes = jobs::available_bytes() / 2;
  return settings;
}

/// Where lines of requests in JSON go: where all others do.
std::shared_ptr<spdlog::logger> make_request_log() {
  const auto log = spdlog::default_logger();
  auto requests = std::make_shared<spdlog::logger>(request_logger, log->sinks().begin(), log->sinks().end());
  requests->set_level(log->level());
  return requests;
}

Result<std::unique_ptr<store::GraphStore>> open_store(const Settings& settings) {
  if (settings.data.empty()) return store::GraphStore::in_memory(settings.store_bytes);
  auto opened = store::GraphStore::open(settings.data, settings.store_bytes);
  if (opened || settings.needs_data) return opened;
  const std::string& reason = opened.problems().front().detail;
  spdlog::warn("graphs cannot be stored: {}", escape_controls(reason));
  return store::GraphStore::refusing("This server stores no graphs: " + reason + ".");
}

/// Where the uploaded files are kept beside the graphs; null where those are in memory.
std::shared_ptr<AssetKeeper> asset_files(const store::GraphStore& graphs, const Settings& settings) {
  const auto folder = graphs.folder();
  if (!folder) return nullptr;
  return std::make_shared<store::AssetFiles>(*folder, settings.asset_file_bytes, [&graphs](const Digest& asset) {
    const Result<bool> named = graphs.names(asset);
    return !named || *named;
  });
}

}  // namespace

/// Members are destroyed from the last one up: first what computes, then what writes answers, then the connections.
struct Server::State {
  State(const Engine& engine, const Settings& chosen, Page page, Examples examples,
        std::unique_ptr<store::GraphStore> kept)
      : settings(decided(chosen)),
        graphs(std::move(kept)),
        metrics(engine.catalogue().value("engine", "")),
        wrong_tokens(settings.wrong_tokens),
        connections(
            settings, threads,
            [this](const RequestHead& head, const Exchange& exchange) { return admit(application, head, exchange); },
            [this](const std::shared_ptr<Call>& call) { answer(application, call); },
            [this](const Access& access, const Exchange& exchange) { note(access, exchange); }),
        threads(settings.answer_threads),
        flights(queue, alarms),
        link(settings.queue ? std::make_unique<queue::Link>(*settings.queue) : nullptr),
        queued(link ? std::make_unique<jobs::QueuedSweeps>(engine, *link, settings.base_path) : nullptr),
        shared(link ? std::make_unique<jobs::SharedResults>(engine, *link) : nullptr),
        local(engine, flights, settings.base_path),
        runner(engine, flights, sweeps(), store::JobStore(graphs->database()), job_terms(settings)),
        job_feeds(runner, alarms, threads, settings.base_path),
        application{.engine = engine,
                    .settings = settings,
                    .page = std::move(page),
                    .examples = std::move(examples),
                    .threads = threads,
                    .flights = flights,
                    .queue = queue,
                    .connections = connections,
                    .metrics = metrics,
                    .wrong_tokens = wrong_tokens,
                    .known = Cache(settings.known_bytes),
                    .artifacts = Artifacts(settings.artifact_bytes),
                    .graphs = *graphs,
                    .sweeps = sweeps(),
                    .queued_sweeps = queued.get(),
                    .queue_link = link.get(),
                    .shared_results = shared.get(),
                    .jobs = runner,
                    .job_feeds = job_feeds,
                    .catalogue = static_answer(dump(engine.catalogue())),
                    .document_schema = static_answer(dump(document_schema(engine.catalogue()))),
                    .example_list = {},
                    .openapi = {},
                    .docs = {},
                    .docs_style = static_answer(std::string(docs_style_sheet()))},
        queue({.places = settings.compute_slots,
               .waiting = settings.compute_queue,
               .bytes = settings.compute_bytes,
               .waiting_work = settings.compute_slots * short_wait},
              jobs::give_back_free_memory) {
    engine.keep_assets_in(asset_files(*graphs, settings));
    application.example_list = static_answer(application.examples.list().dump());
    const std::string version = engine.catalogue().value("engine", "");
    application.openapi = static_answer(dump(openapi_document(routes(), version, settings.base_path)));
    application.docs = static_answer(docs_html(routes(), version));
  }

  ~State() { application.engine.keep_assets_in(nullptr); }

  jobs::Sweeps& sweeps() {
    if (queued) return *queued;
    return local;
  }

  const Settings settings;
  const std::shared_ptr<spdlog::logger> request_log = make_request_log();

  /// What is known of a request once it has been answered, told to who operates the server.
  void note(const Access& access, const Exchange& exchange) {
    const std::string path = decoded_path(std::string_view(access.path).substr(0, access.path.find('?')));
    const auto below = below_base(path, settings.base_path);
    const bool read = access.method != "-";
    const std::string_view route = read && below ? pattern_of(application, access.method, *below) : "other";
    if (settings.log_format == LogFormat::json) {
      request_log->info(request_members(access, exchange, route));
    } else {
      spdlog::info(request_text(access, exchange, route));
    }
    metrics.count(route, read ? access.method : "none", access.status, exchange.milliseconds() / 1000, access.bytes);
  }

  const std::unique_ptr<store::GraphStore> graphs;
  Metrics metrics;
  WrongTokens wrong_tokens;
  Connections connections;
  jobs::Alarms alarms;
  AnswerThreads threads;
  jobs::Flights flights;
  const std::unique_ptr<queue::Link> link;            ///< where there is a queue
  const std::unique_ptr<jobs::QueuedSweeps> queued;   ///< likewise
  const std::unique_ptr<jobs::SharedResults> shared;  ///< likewise
  jobs::LocalSweeps local;
  jobs::JobRunner runner;
  JobFeeds job_feeds;
  Application application;
  jobs::ComputeQueue queue;
  int port = 0;
  bool stopped = false;
};

Result<std::unique_ptr<Server>> Server::start(const Engine& engine, const Settings& settings) try {
  Result<Page> page = settings.web.empty() ? Page() : Page::load(settings.web);
  if (!page) return page.problems();
  Result<Examples> examples = settings.examples.empty() ? Examples() : Examples::load(settings.examples, engine);
  if (!examples) return examples.problems();
  auto graphs = open_store(settings);
  if (!graphs) return graphs.problems();
  auto state = std::make_unique<State>(engine, settings, *std::move(page), *std::move(examples), *std::move(graphs));
  state->port = state->connections.listen();
  if (state->port == 0) {
    return Problem{.code = "address",
                   .detail = "Cannot listen on " + settings.host + " port " + std::to_string(settings.port) + "."};
  }
  state->runner.start();
  state->connections.start();
  return std::unique_ptr<Server>(new Server(std::move(state)));
} catch (const std::bad_alloc&) {
  return Problem{.code = "out-of-memory", .detail = "There is not enough memory to start."};
} catch (const std::system_error& error) {
  return Problem{.code = "out-of-memory", .detail = std::string("The machine gives no threads: ") + error.what()};
}

Server::Server(std::unique_ptr<State> state) : state_(std::move(state)) {}

Server::~Server() { stop(); }

int Server::port() const { return state_->port; }

void Server::stop() {
  if (std::exchange(state_->stopped, true)) return;
  using Clock = Connections::Clock;
  state_->connections.drain();
  state_->runner.stop();
  if (!state_->connections.wait_closed(Clock::now() + state_->settings.drain_deadline)) {
    state_->sweeps().stop_all(StopReason::shutting_down);
    state_->flights.stop_all(StopReason::shutting_down);
    state_->connections.wait_closed(Clock::now() + farewell);
  }
  state_->connections.cut();
  state_->sweeps().finish();
  state_->flights.stop_all(StopReason::shutting_down);
  state_->threads.finish();
}

}  // namespace dini::server
