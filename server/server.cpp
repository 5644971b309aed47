#include "server/server.h"

#include <algorithm>
#include <spdlog/spdlog.h>
#include <thread>

#include "server/guard.h"
#include "server/routes.h"
#include "server/text.h"

namespace dini::server {
namespace {

/// What stopped requests get to send their last answer.
constexpr std::chrono::seconds farewell{2};

std::size_t slots(const Settings& settings) {
  return settings.compute_slots != 0 ? settings.compute_slots : std::max(1u, std::thread::hardware_concurrency());
}

std::size_t queue(const Settings& settings) {
  return settings.compute_queue != 0 ? settings.compute_queue : 16 * slots(settings);
}

void log_access(const Access& access, const Exchange& exchange) {
  spdlog::info("{} {} {} {:.1f}ms {}B {}", escape_controls(access.method, 16), escape_controls(access.path),
               access.status, exchange.milliseconds(), access.bytes, exchange.id);
}

}  // namespace

struct Server::State {
  State(const Engine& engine, const Settings& chosen, Page page, Examples examples)
      : settings(chosen),
        application{engine, settings, std::move(page), std::move(examples), Gate(slots(settings), queue(settings)), {},
                    {},     {}},
        guard(
            settings,
            [&limits = engine.limits()](std::string_view method, std::string_view target) {
              return body_limit(method, target, limits);
            },
            [this](const httplib::Request& request, Exchange& exchange) {
              return answer(application, request, exchange);
            },
            log_access) {}

  const Settings settings;
  Application application;
  Guard guard;
  int port = 0;
  std::thread acceptor;
};

Result<std::unique_ptr<Server>> Server::start(const Engine& engine, const Settings& settings) {
  Result<Page> page = settings.web.empty() ? Page() : Page::load(settings.web);
  if (!page) return page.problems();
  Result<Examples> examples = settings.examples.empty() ? Examples() : Examples::load(settings.examples, engine);
  if (!examples) return examples.problems();
  auto state = std::make_unique<State>(engine, settings, *std::move(page), *std::move(examples));
  state->port = state->guard.bind();
  if (state->port == 0) {
    return Problem{.code = "address",
                   .detail = "Cannot listen on " + settings.host + " port " + std::to_string(settings.port) + "."};
  }
  state->acceptor = std::thread([guard = &state->guard] { guard->run(); });
  return std::unique_ptr<Server>(new Server(std::move(state)));
}

Server::Server(std::unique_ptr<State> state) : state_(std::move(state)) {}

Server::~Server() { stop(); }

int Server::port() const { return state_->port; }

void Server::stop() {
  if (!state_->acceptor.joinable()) return;
  state_->guard.stop_accepting();
  state_->acceptor.join();
  const auto drained = std::chrono::steady_clock::now() + state_->settings.drain_deadline;
  if (state_->guard.wait_closed(drained)) return;
  state_->application.running.stop_all(StopReason::shutting_down);
  if (state_->guard.wait_closed(std::chrono::steady_clock::now() + farewell)) return;
  state_->guard.cut_connections();
}

}  // namespace dini::server
