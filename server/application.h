#pragma once

#include <memory>
#include <string>
#include <vector>

#include "graph/cache.h"
#include "jobs/flights.h"
#include "jobs/supersede.h"
#include "server/answer_threads.h"
#include "server/call.h"
#include "server/examples.h"
#include "server/page.h"
#include "server/settings.h"
#include "service/engine.h"

namespace dini::server {

/// What the handlers share.
struct Application {
  const Engine& engine;
  const Settings& settings;
  Page page;
  Examples examples;
  AnswerThreads& threads;
  jobs::Flights& flights;
  jobs::Supersede supersede = {};
  Cache known;  ///< requests that were read and checked, by their exact bytes
  StaticAnswer catalogue;
  StaticAnswer example_list;
  StaticAnswer openapi;
  StaticAnswer docs;
  StaticAnswer docs_style;
};

/// One request at its handler.
struct Context {
  Application& application;
  std::shared_ptr<Call> call;
  std::vector<std::string> arguments = {};  ///< what the braces of the route's path stand for, in their order

  const Engine& engine() const { return application.engine; }
  const Request& request() const { return call->request; }
  const Exchange& exchange() const { return call->exchange; }
};

}  // namespace dini::server
