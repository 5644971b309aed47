#pragma once

#include "draco/topology_cache.h"
#include "graph/cache.h"
#include "service/asset_library.h"
#include "service/engine.h"
#include "service/history.h"
#include "service/prepare.h"
#include "service/report.h"
#include "service/value_source.h"

namespace dini {

/// The engine over the whole catalogue of nodes. What it computes it keeps under `cache_bytes`.
class CatalogueEngine final : public Engine, public ValueSource {
 public:
  CatalogueEngine(const Limits& limits, std::vector<FileFormat> formats);

  const Limits& limits() const override { return limits_; }
  std::span<const FileFormat> formats() const override { return formats_; }
  const Json& catalogue() const override { return catalogue_; }
  Result<AssetSummary> add_asset(std::string_view bytes, const std::string& name, const Cancel& cancel) const override;
  SharedBytes asset(std::string_view sha256) const override { return assets_.bytes(sha256); }
  void keep_assets_in(std::shared_ptr<AssetKeeper> keeper) const override { assets_.keep_in(std::move(keeper)); }
  SharedGraph read(const Json& document) const override;
  Result<Json> interface(const Graph& graph) const override;
  Result<Json> validate(const Graph& graph, const Json& parameters, const Cancel& cancel, Sent sent) const override;
  Result<SharedPrepared> prepare(const EvaluateRequest& request, const Cancel& cancel) const override;
  std::vector<std::string> blocked(const EvaluateRequest& request, const Cancel& cancel) const override;
  Json explain(const Prepared& prepared) const override;
  SharedComputed find(const Prepared& prepared) const override;
  Result<SharedComputed> compute(const Prepared& prepared, const Job& job) const override;
  bool is_shareable(const Prepared& prepared) const override;
  std::string kept_form(const Prepared& prepared, const Computed& computed) const override;
  SharedComputed restore(const Prepared& prepared, std::string_view kept) const override;
  using Engine::report;
  Json report(const Prepared& prepared, const Computed& computed, Sent sent, Extent extent) const override;
  CacheState cache_state() const override { return {cache_.bytes(), cache_.size(), cache_.evictions()}; }
  std::vector<NodeTime> node_times() const override { return history_.node_times(); }
  void forget() const override {
    cache_.clear();
    history_.clear();
    topologies_.clear();
  }
  Result<SharedBytes> inspect(const InspectRequest& request, const Job& job) const override;
  const ValueSource* value_source() const override { return this; }
  Result<std::vector<SettingValues>> values(const ValuesRequest& request, std::span<const Json> settings,
                                            const Cancel& cancel) const override;
  Result<std::vector<std::string>> exported_places(const Graph& graph) const override;
  Result<SharedAssetFile> mesh_file(const std::string& name, const Cancel& cancel) const override;

 private:
  AssetFinder asset_finder(const Cancel& cancel) const {
    return [this, &cancel](std::string_view text) { return assets_.find(text, cancel); };
  }
  Environment environment(const Cancel& cancel) const {
    return {registry_, limits_, formats_, topologies_, asset_finder(cancel)};
  }

  /// What has to be evaluated: the targets, and what is drawn unless the drawing is known.
  std::vector<std::size_t> wanted_nodes(const PreparedGraph& prepared) const;

  /// The drawn previews, from the cache or into it.
  Result<std::shared_ptr<const ToldParts>> told_parts(const PreparedGraph& prepared, const Evaluation& evaluation,
                                                      const Cancel& cancel) const;
  Result<SharedFile> preview_file(const PreparedGraph& prepared, const Evaluation& evaluation,
                                  const Cancel& cancel) const;

  const Limits limits_;
  const std::vector<FileFormat> formats_;
  Registry registry_;
  Json catalogue_;
  mutable Cache cache_;
  mutable TopologyCache topologies_;
  mutable History history_;
  mutable AssetLibrary assets_;
};

}  // namespace dini
