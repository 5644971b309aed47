#pragma once

#include <httplib.h>
#include <string>

#include "server/examples.h"
#include "server/gate.h"
#include "server/known_requests.h"
#include "server/page.h"
#include "server/reply.h"
#include "server/running.h"
#include "server/settings.h"
#include "server/supersede.h"
#include "service/engine.h"

namespace dini::server {

/// What the handlers share.
struct Application {
  const Engine& engine;
  const Settings& settings;
  Page page;
  Examples examples;
  Gate gate;
  RunningRequests running;
  Supersede supersede;
  KnownRequests known;
};

/// One request on its way through a handler.
struct Call {
  Application& application;
  const httplib::Request& request;
  Exchange& exchange;
  std::string argument;  ///< the part of the path that the route's {..} stands for

  const Engine& engine() const { return application.engine; }
  std::string header(const char* name) const { return request.get_header_value(name); }
};

/// The longest body that an address takes: files have a limit of their own.
std::size_t body_limit(std::string_view method, std::string_view target, const Limits& limits);

/// Finds the handler and lets it answer. Never throws: what a handler lets escape is our bug and becomes a bare 500.
Reply answer(Application& application, const httplib::Request& request, Exchange& exchange);

}  // namespace dini::server
