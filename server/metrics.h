#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dini::server {

/// One number as it is at this moment.
struct Reading {
  std::string name;  ///< as Prometheus has it
  std::string help;  ///< one sentence
  double value = 0;
  bool counts = false;    ///< it only ever grows
  std::string type = "";  ///< of nodes, where there is such a number for each
};

/// What the server counts of its requests, for Prometheus.
class Metrics {
 public:
  explicit Metrics(const std::string& version);
  ~Metrics();

  /// A request that has been answered, by the pattern of its route. Any thread.
  void count(std::string_view route, std::string_view method, int status, double seconds, std::size_t bytes);

  /// All counts, and these readings (those for types of nodes one after another), in the text format of Prometheus
  /// (version 0.0.4).
  std::string text(const std::vector<Reading>& readings) const;

 private:
  struct Families;
  std::unique_ptr<Families> families_;
};

}  // namespace dini::server
