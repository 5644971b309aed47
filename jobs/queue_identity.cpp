#include "jobs/queue_identity.h"

#include <algorithm>
#include <array>

#include "graph/digest.h"
#include "service/limit_table.h"

namespace dini::jobs {
namespace {

/// Limits that neither decide what is answered nor whether a request can be read.
constexpr std::array elsewhere = {"cache_bytes", "interactive_milliseconds", "asset_store_bytes"};

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
