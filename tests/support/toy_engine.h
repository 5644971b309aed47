#pragma once

// A stand-in for the engine, so that the tests of the server and of the command line decide what evaluation does.
//
// Its graphs are {"format": 1, "nodes": {"out": {"inputs": {...}}}} with these inputs:
//   milliseconds  how long an evaluation takes, while it looks at its Cancel
//   bytes         how large the model is
//   problem       the code of the problem that the evaluation ends with
//   invalid       the code of the problem that checking finds
//   throws        true: an exception escapes, as if by a bug of ours
//   memory        true: memory runs out
// A value of its parameter `fatal` that is 1 ends the process. Its formats are "glb" and "toy", whose files begin with
// that word. Everything but `milliseconds` is its content; what was computed once is known from then on, but for
// `throws`. Every evaluation is predicted to need one byte of memory. Its files are refused when they begin with
// "broken" (invalid-asset) or "large" (limit-exceeded).

#include <atomic>
#include <cstddef>
#include <map>
#include <mutex>

#include "service/engine.h"

namespace dini::toy {

struct Counters {
  std::atomic<std::size_t> prepared = 0;  ///< requests checked
  std::atomic<std::size_t> started = 0;   ///< evaluations begun
  std::atomic<std::size_t> finished = 0;  ///< and ended, one way or another
  std::atomic<std::size_t> canceled = 0;  ///< of these, stopped by their Cancel
};

/// Of all toy engines of the program.
Counters& counters();

class ToyEngine final : public Engine {
 public:
  explicit ToyEngine(const Limits& limits = {});

  const Limits& limits() const override { return limits_; }
  std::span<const FileFormat> formats() const override { return formats_; }
  const Json& catalogue() const override { return catalogue_; }
  Result<AssetSummary> add_asset(std::string_view bytes, const std::string& name, const Cancel& cancel) const override;
  SharedBytes asset(std::string_view) const override { return nullptr; }
  void keep_assets_in(std::shared_ptr<AssetKeeper>) const override {}
  SharedGraph read(const Json& document) const override;
  Result<Json> interface(const Graph& graph) const override;
  Result<Json> validate(const Graph& graph, const Json& parameters, const Cancel& cancel, Sent sent) const override;
  Result<SharedPrepared> prepare(const EvaluateRequest& request, const Cancel& cancel) const override;
  std::vector<std::string> blocked(const EvaluateRequest& request, const Cancel& cancel) const override;
  Json explain(const Prepared& prepared) const override;
  SharedComputed find(const Prepared& prepared) const override;
  Result<SharedComputed> compute(const Prepared& prepared, const Job& job) const override;
  using Engine::report;
  Json report(const Prepared& prepared, const Computed& computed, Sent sent, Extent extent) const override;
  CacheState cache_state() const override { return {}; }
  void forget() const override;
  Result<SharedBytes> inspect(const InspectRequest& request, const Job& job) const override;

 private:
  const Limits limits_;
  const std::vector<FileFormat> formats_;
  const Json catalogue_;
  mutable std::mutex mutex_;
  mutable std::map<Digest, SharedComputed> known_;
};

}  // namespace dini::toy
