#include "jobs/queue_identity.h"

#include <algorithm>
#include <array>

#include "graph/digest.h"
#include "service/limit_table.h"

namespace dini::jobs {
namespace {

/// Limits that decide how long something takes or how much of it is asked for at once, and not what is answered.
constexpr std::array elsewhere = {"cache_bytes", "interactive_milliseconds", "sweep_milliseconds", "sweep_variants",
                                  "sweep_work",  "asset_store_bytes"};

}  // namespace

std::string version_of(const Engine& engine) { return engine.catalogue().value("engine", ""); }

std::string queue_identity(const Engine& engine) {
  DigestBuilder digest;
  for (const Limit<Limits>& limit : evaluation_limits()) {
    if (std::ranges::find(elsewhere, limit.name) != elsewhere.end()) continue;
    digest.text(limit.name).integer(limit.get(engine.limits()));
  }
  return version_of(engine) + "-" + to_hex(digest.finish()).substr(0, 8);
}

}  // namespace dini::jobs
