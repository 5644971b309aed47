#include "cli/worker_metrics.h"

#include <prometheus/collectable.h>
#include <prometheus/exposer.h>
#include <prometheus/metric_family.h>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/number_in.h"
#include "cli/problems.h"

namespace dini::cli {
namespace {

using prometheus::MetricFamily;
using prometheus::MetricType;

MetricFamily family_of(const std::string& name, const std::string& help, MetricType type, double value) {
  prometheus::ClientMetric metric;
  (type == MetricType::Counter ? metric.counter.value : metric.gauge.value) = value;
  return {.name = name, .help = help, .type = type, .metric = {metric}};
}

class WorkerReadings : public prometheus::Collectable {
 public:
  WorkerReadings(const jobs::Worker& worker, std::string version) : worker_(worker), version_(std::move(version)) {}

  std::vector<MetricFamily> Collect() const override {
    const jobs::Worker::Counts counts = worker_.counts();
    MetricFamily build = family_of("dini_build_info", "The engine that runs here: always 1.", MetricType::Gauge, 1);
    build.metric.front().label = {{"version", version_}};
    return {
        std::move(build),
        family_of("dini_worker_variants_total", "Variants whose line was taken.", MetricType::Counter,
                  static_cast<double>(counts.counted)),
        family_of("dini_worker_in_vain_total",
                  "Variants that others had computed before, that nobody wanted any more, or that failed to be told.",
                  MetricType::Counter, static_cast<double>(counts.in_vain)),
        family_of("dini_worker_seconds_total", "Seconds spent with variants, over all threads.", MetricType::Counter,
                  counts.seconds),
        family_of("dini_worker_running", "Variants that are computed.", MetricType::Gauge,
                  static_cast<double>(counts.running))};
  }

 private:
  const jobs::Worker& worker_;
  const std::string version_;
};

/// HOST:PORT of what people write; nothing where that is no port.
std::optional<std::string> endpoint_of(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  const std::string_view port = std::string_view(address).substr(colon == std::string::npos ? 0 : colon + 1);
  const auto number = number_in<unsigned>(port);
  if (!number || *number < 1 || *number > 65535) return std::nullopt;
  return colon == std::string::npos ? "127.0.0.1:" + address : address;
}

}  // namespace

struct WorkerMetrics::Served {
  Served(const std::string& endpoint, std::shared_ptr<prometheus::Collectable> told)
      : readings(std::move(told)), exposer(endpoint, 1) {
    exposer.RegisterCollectable(readings);
  }

  std::shared_ptr<prometheus::Collectable> readings;
  prometheus::Exposer exposer;
};

WorkerMetrics::WorkerMetrics(std::unique_ptr<Served> served) : served_(std::move(served)) {}
WorkerMetrics::WorkerMetrics(WorkerMetrics&&) noexcept = default;
WorkerMetrics::~WorkerMetrics() = default;

Result<WorkerMetrics> WorkerMetrics::serve(const std::string& address, const jobs::Worker& worker,
                                           const std::string& version) {
  const auto endpoint = endpoint_of(address);
  if (!endpoint) return usage_problem("--metrics takes PORT or HOST:PORT, not '" + address + "'");
  try {
    return WorkerMetrics(std::make_unique<Served>(*endpoint, std::make_shared<WorkerReadings>(worker, version)));
  } catch (const std::exception&) {
    return Problem{.code = "address", .detail = "--metrics " + address + ": that cannot be listened at"};
  }
}

}  // namespace dini::cli
