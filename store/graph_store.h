#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/digest.h"
#include "graph/file.h"
#include "graph/problem.h"

namespace dini::store {

class Database;

/// What is known of one version of a graph without its document.
struct GraphVersion {
  std::string id;
  std::int64_t version = 0;  ///< counts from 1
  std::int64_t created = 0;  ///< milliseconds since 1970, UTC
  Digest hash{};             ///< of the graph: as `graph_hash`
  Digest digest{};           ///< of the document's bytes
  std::int64_t bytes = 0;    ///< of the document
  std::string title;
};

struct StoredGraph : GraphVersion {
  SharedBytes document;  ///< as it was given, byte for byte
};

/// A document to keep.
struct NewGraph {
  std::string id;
  Digest hash{};
  std::string title;
  std::string_view document;
};

/// Whether to go on, by the version that is current; null when there is none.
using Condition = std::function<bool(const GraphVersion* current)>;

enum class WriteOutcome { created, replaced, unchanged, deleted, refused };

struct Written {
  WriteOutcome outcome;
  std::optional<GraphVersion> current;  ///< of the graph after this
};

/// One page of a list.
struct GraphPage {
  std::vector<GraphVersion> graphs;
  bool more = false;
};

/// Graphs by name, every version of them for ever. A version never changes; a deleted graph keeps its versions until
/// they are purged, and its numbers go on where they ended. All problems are `storage-full` or `storage-failed`.
class GraphStore {
 public:
  /// The graphs of a data folder, which this process alone writes; see Database::open.
  static Result<std::unique_ptr<GraphStore>> open(const std::filesystem::path& folder, std::size_t most_bytes);
  /// Graphs that are gone with the process.
  static std::unique_ptr<GraphStore> in_memory(std::size_t most_bytes);
  /// No graphs, and every write is `storage-failed` with that detail.
  static std::unique_ptr<GraphStore> refusing(const std::string& detail);
  /// The graphs of a data folder that another process may be writing, to look at them only.
  static Result<std::unique_ptr<GraphStore>> open_to_read(const std::filesystem::path& folder);
  ~GraphStore();

  /// Keeps a document as the next version of its graph, if the condition lets it. What is the current document already
  /// is `unchanged` whatever the condition says, so that a write may be tried again whose answer was lost.
  Result<Written> put(const NewGraph& graph, const Condition& condition);
  /// `unchanged` when there is none.
  Result<Written> remove(std::string_view id, const Condition& condition);

  /// The current version, or one by its number, that of a deleted graph too; nothing when there is none.
  Result<std::optional<StoredGraph>> find(std::string_view id, std::optional<std::int64_t> version) const;

  /// The same without the document.
  Result<std::optional<GraphVersion>> look_up(std::string_view id, std::optional<std::int64_t> version) const;

  /// Graphs by id, those after `after` only, and those only whose id or title contains `query` (ASCII letters in any
  /// case).
  Result<GraphPage> list(std::string_view after, std::string_view query, std::size_t limit) const;

  /// Every version of a graph, the newest first; empty for a graph that never was.
  Result<std::vector<GraphVersion>> versions(std::string_view id) const;

  /// The data folder that this process writes; nothing when graphs are in memory, or are not kept at all.
  std::optional<std::filesystem::path> folder() const;

  /// Whether some version, that of a deleted graph too, names an uploaded file.
  Result<bool> names(const Digest& asset) const;

  /// Why nothing can be written just now, from what became of the last write; after one that failed another is tried.
  /// Nothing for a store that refuses all writes: nobody waits for that to end.
  std::optional<Problem> check_writing();

  /// Forgets deleted graphs for ever, and gives their room back. How many there were.
  Result<std::size_t> purge();
  /// Writes all of it into a new file, as it is at one moment.
  Result<bool> back_up(const std::filesystem::path& file) const;
  /// What is wrong with it, in words; empty when nothing is. Reads everything.
  Result<std::string> fault() const;

  /// Where else may be kept what belongs to the same data.
  const std::shared_ptr<Database>& database() const { return database_; }

 private:
  explicit GraphStore(std::shared_ptr<Database> database);

  std::shared_ptr<Database> database_;
};

}  // namespace dini::store
