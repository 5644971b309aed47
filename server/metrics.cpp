#include "server/metrics.h"

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>
#include <sstream>

namespace dini::server {
namespace {

/// From what is known already to a large evaluation, in seconds.
const prometheus::Histogram::BucketBoundaries latencies = {0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05,
                                                           0.1,    0.25,  0.5,    1,     2.5,  5,     10};

prometheus::ClientMetric metric_of(const Reading& reading) {
  prometheus::ClientMetric metric;
  if (!reading.type.empty()) metric.label = {{"type", reading.type}};
  if (reading.counts) {
    metric.counter.value = reading.value;
  } else {
    metric.gauge.value = reading.value;
  }
  return metric;
}

prometheus::MetricFamily family_of(const Reading& reading) {
  return {.name = reading.name,
          .help = reading.help,
          .type = reading.counts ? prometheus::MetricType::Counter : prometheus::MetricType::Gauge,
          .metric = {metric_of(reading)}};
}

}  // namespace

struct Metrics::Families {
  prometheus::Registry registry;
  prometheus::Family<prometheus::Counter>& requests =
      prometheus::BuildCounter().Name("dini_requests_total").Help("Requests that were answered.").Register(registry);
  prometheus::Family<prometheus::Histogram>& seconds =
      prometheus::BuildHistogram()
          .Name("dini_request_seconds")
          .Help("From the first byte of a request to the last one of its answer.")
          .Register(registry);
  prometheus::Family<prometheus::Counter>& bytes = prometheus::BuildCounter()
                                                       .Name("dini_answer_bytes_total")
                                                       .Help("Bytes of answers, heads included.")
                                                       .Register(registry);
  prometheus::Family<prometheus::Gauge>& build =
      prometheus::BuildGauge().Name("dini_build_info").Help("The engine that runs here: always 1.").Register(registry);
};

Metrics::Metrics(const std::string& version) : families_(std::make_unique<Families>()) {
  families_->build.Add({{"version", version}}).Set(1);
}

Metrics::~Metrics() = default;

void Metrics::count(std::string_view route, std::string_view method, int status, double seconds, std::size_t bytes) {
  const std::string name(route);
  families_->requests.Add({{"route", name}, {"method", std::string(method)}, {"status", std::to_string(status)}})
      .Increment();
  families_->seconds.Add({{"route", name}}, latencies).Observe(seconds);
  families_->bytes.Add({{"route", name}}).Increment(static_cast<double>(bytes));
}

std::string Metrics::text(const std::vector<Reading>& readings) const {
  std::vector<prometheus::MetricFamily> all = families_->registry.Collect();
  for (const Reading& reading : readings) {
    const bool more_of_last = !reading.type.empty() && !all.empty() && all.back().name == reading.name;
    if (more_of_last) {
      all.back().metric.push_back(metric_of(reading));
    } else {
      all.push_back(family_of(reading));
    }
  }
  std::ostringstream out;
  prometheus::TextSerializer().Serialize(out, all);
  return out.str();
}

}  // namespace dini::server
