#pragma once

#include <memory>
#include <string>
#include <vector>

#include "graph/cache.h"
#include "jobs/flights.h"
#include "jobs/job_runner.h"
#include "jobs/queued_sweeps.h"
#include "jobs/shared_results.h"
#include "jobs/supersede.h"
#include "server/answer_threads.h"
#include "server/artifacts.h"
#include "server/call.h"
#include "server/examples.h"
#include "server/job_events.h"
#include "server/page.h"
#include "server/settings.h"
#include "service/engine.h"
#include "store/graph_store.h"

namespace dini::server {

class Connections;
class Metrics;
class WrongTokens;

/// What the handlers share.
struct Application {
  const Engine& engine;
  const Settings& settings;
  Page page;
  Examples examples;
  AnswerThreads& threads;
  jobs::Flights& flights;
  const jobs::ComputeQueue& queue;
  const Connections& connections;
  Metrics& metrics;
  WrongTokens& wrong_tokens;
  jobs::Supersede supersede = {};
  Cache known;  ///< bodies that were read, by their bytes, and requests that were checked, by their identity
  Artifacts artifacts;
  store::GraphStore& graphs;
  jobs::Sweeps& sweeps;
  const jobs::QueuedSweeps* queued_sweeps = nullptr;  ///< the same, where there is a queue
  queue::Link* queue_link = nullptr;                  ///< to that queue
  jobs::SharedResults* shared_results = nullptr;      ///< that lie there
  jobs::JobRunner& jobs;
  JobFeeds& job_feeds;
  StaticAnswer catalogue;
  StaticAnswer document_schema;
  StaticAnswer example_list;
  StaticAnswer openapi;
  StaticAnswer docs;
  StaticAnswer docs_style;

  /// What a request comes to, from wherever that is had.
  Result<SharedComputed> compute(const Prepared& prepared, const Job& job) const;

  /// Lets go of everything that could be made again: memory has run out, and the next request shall find some.
  void release_memory();
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
