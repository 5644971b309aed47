#include "server/application.h"

#include "jobs/process_memory.h"

namespace dini::server {

void Application::release_memory() {
  engine.forget();
  known.clear();
  artifacts.clear();
  jobs::give_back_free_memory();
}

}  // namespace dini::server
