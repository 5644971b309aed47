#include "server/application.h"

#include "jobs/process_memory.h"

namespace dini::server {

Result<SharedComputed> Application::compute(const Prepared& prepared, const Job& job) const {
  return shared_results != nullptr ? shared_results->compute(prepared, job) : engine.compute(prepared, job);
}

void Application::release_memory() {
  engine.forget();
  known.clear();
  artifacts.clear();
  jobs::give_back_free_memory();
}

}  // namespace dini::server
