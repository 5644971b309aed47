#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <vector>

#include "graph/digest.h"

namespace dini {

/// What was made before, by a digest of everything it depends on, under one byte budget; the least recently used go
/// first. Safe to use from many threads.
///
/// A digest says what kind of thing it stands for (every kind begins its digests with a word of its own), so a thing is
/// always found as the type it was inserted as. Things larger than the whole budget are not kept.
///
/// A large thing may name its place, a digest of what it is the newest version of. While somebody drags a slider every
/// frame makes a version that is seldom asked for again; few of them are kept, so that the memory of old versions
/// serves the next.
class Cache {
 public:
  /// From so many bytes on a thing is large.
  static constexpr std::size_t large = std::size_t{1} << 21;
  /// How many large things are kept that name the same place.
  static constexpr std::size_t most_versions = 4;

  explicit Cache(std::size_t budget) : budget_(budget) {}

  /// The thing, or null. Counts as a use.
  template <class T>
  std::shared_ptr<const T> find(const Digest& digest) {
    return std::static_pointer_cast<const T>(find_any(digest));
  }

  /// Keeps a thing that holds `bytes` of memory. One that is there already stays.
  template <class T>
  void insert(const Digest& digest, std::shared_ptr<const T> thing, std::size_t bytes,
              const std::optional<Digest>& place = std::nullopt) {
    insert_any(digest, std::move(thing), bytes, place);
  }

  /// Whether it is there. Does not count as a use.
  bool contains(const Digest& digest) const;

  /// Lets everything go.
  void clear();

  std::size_t bytes() const;
  std::size_t size() const;
  /// How many things had to make room so far.
  std::size_t evictions() const;

 private:
  struct Entry {
    Digest digest;
    std::shared_ptr<const void> thing;
    std::size_t bytes;
    std::optional<Digest> place;  ///< of a large thing
    std::uint64_t used;           ///< larger than of all that were used before
  };
  using Entries = std::list<Entry>;

  std::shared_ptr<const void> find_any(const Digest& digest);
  void insert_any(const Digest& digest, std::shared_ptr<const void> thing, std::size_t bytes,
                  const std::optional<Digest>& place);
  /// Moves an entry to those that go.
  void evict(Entries::iterator entry, Entries& evicted);

  const std::size_t budget_;
  mutable std::mutex mutex_;
  Entries entries_;  ///< most recently used first
  std::unordered_map<Digest, Entries::iterator, DigestHash> index_;
  std::unordered_map<Digest, std::vector<Entries::iterator>, DigestHash> versions_;  ///< by place
  std::uint64_t uses_ = 0;
  std::size_t bytes_ = 0;
  std::size_t evictions_ = 0;
};

}  // namespace dini
