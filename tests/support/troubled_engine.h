#pragma once

#include <atomic>
#include <new>
#include <stdexcept>
#include <thread>

#include "graph/stopped.h"
#include "service/engine.h"
#include "service/value_source.h"

namespace dini::support {

/// What the engine does instead of its work.
enum class Trouble { none, never_ends, throws, no_memory };

/// The real engine, which can be told to get into trouble whenever it checks or computes.
class TroubledEngine final : public Engine, public ValueSource {
 public:
  TroubledEngine(const Limits& limits, const std::atomic<Trouble>& trouble)
      : engine_(make_engine(limits)), trouble_(trouble) {}

  const Limits& limits() const override { return engine_->limits(); }
  std::span<const FileFormat> formats() const override { return engine_->formats(); }
  const Json& catalogue() const override { return engine_->catalogue(); }
  Result<AssetSummary> add_asset(std::string_view bytes, const std::string& name, const Cancel& cancel) const override {
    if (auto problem = meet_trouble(cancel)) return *std::move(problem);
    return engine_->add_asset(bytes, name, cancel);
  }
  SharedBytes asset(std::string_view sha256) const override { return engine_->asset(sha256); }
  void keep_assets_in(std::shared_ptr<AssetKeeper> keeper) const override {
    engine_->keep_assets_in(std::move(keeper));
  }
  SharedGraph read(const Json& document) const override { return engine_->read(document); }
  Result<Json> interface(const Graph& graph) const override { return engine_->interface(graph); }
  Result<Json> validate(const Graph& graph, const Json& parameters, const Cancel& cancel,
                        dini::Sent sent) const override {
    if (auto problem = meet_trouble(cancel)) return *std::move(problem);
    return engine_->validate(graph, parameters, cancel, sent);
  }
  Result<SharedPrepared> prepare(const EvaluateRequest& request, const Cancel& cancel) const override {
    return engine_->prepare(request, cancel);
  }
  std::vector<std::string> blocked(const EvaluateRequest& request, const Cancel& cancel) const override {
    return engine_->blocked(request, cancel);
  }
  Json explain(const Prepared& prepared) const override { return engine_->explain(prepared); }
  SharedComputed find(const Prepared& prepared) const override {
    return trouble_ == Trouble::none ? engine_->find(prepared) : nullptr;
  }
  Result<SharedComputed> compute(const Prepared& prepared, const Job& job) const override {
    if (auto problem = meet_trouble(job.cancel)) return *std::move(problem);
    return engine_->compute(prepared, job);
  }
  using Engine::report;
  Json report(const Prepared& prepared, const Computed& computed, dini::Sent sent, Extent extent) const override {
    return engine_->report(prepared, computed, sent, extent);
  }
  Result<SharedBytes> inspect(const InspectRequest& request, const Job& job) const override {
    if (auto problem = meet_trouble(job.cancel)) return *std::move(problem);
    return engine_->inspect(request, job);
  }

  const ValueSource* value_source() const override { return this; }
  Result<std::vector<SettingValues>> values(const ValuesRequest& request, std::span<const Json> settings,
                                            const Cancel& cancel) const override {
    if (auto problem = meet_trouble(cancel)) return *std::move(problem);
    return engine_->value_source()->values(request, settings, cancel);
  }
  Result<std::vector<std::string>> exported_places(const Graph& graph) const override {
    return engine_->value_source()->exported_places(graph);
  }
  Result<SharedAssetFile> mesh_file(const std::string& name, const Cancel& cancel) const override {
    return engine_->value_source()->mesh_file(name, cancel);
  }
  CacheState cache_state() const override { return engine_->cache_state(); }
  void forget() const override { engine_->forget(); }

 private:
  std::optional<Problem> meet_trouble(const Cancel& cancel) const {
    switch (trouble_.load()) {
      case Trouble::none:
        return std::nullopt;
      case Trouble::throws:
        throw std::runtime_error("a bug");
      case Trouble::no_memory:
        throw std::bad_alloc();
      case Trouble::never_ends:
        break;
    }
    while (!cancel.stopped()) std::this_thread::yield();
    return stopped_problem(cancel.reason());
  }

  const std::unique_ptr<Engine> engine_;
  const std::atomic<Trouble>& trouble_;
};

}  // namespace dini::support
