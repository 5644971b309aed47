#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "graph/digest.h"

namespace dini {

/// What was made before, by a digest of everything it depends on, under one byte budget; the least recently used go
/// first. Safe to use from many threads.
///
/// A digest says what kind of thing it stands for (every kind begins its digests with a word of its own), so a thing is
/// always found as the type it was inserted as. Things larger than the whole budget are not kept.
class Cache {
 public:
  explicit Cache(std::size_t budget) : budget_(budget) {}

  /// The thing, or null. Counts as a use.
  template <class T>
  std::shared_ptr<const T> find(const Digest& digest) {
    return std::static_pointer_cast<const T>(find_any(digest));
  }

  /// Keeps a thing that holds `bytes` of memory. One that is there already stays.
  template <class T>
  void insert(const Digest& digest, std::shared_ptr<const T> thing, std::size_t bytes) {
    insert_any(digest, std::move(thing), bytes);
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
  };

  std::shared_ptr<const void> find_any(const Digest& digest);
  void insert_any(const Digest& digest, std::shared_ptr<const void> thing, std::size_t bytes);

  const std::size_t budget_;
  mutable std::mutex mutex_;
  std::list<Entry> entries_;  ///< most recently used first
  std::unordered_map<Digest, std::list<Entry>::iterator, DigestHash> index_;
  std::size_t bytes_ = 0;
  std::size_t evictions_ = 0;
};

}  // namespace dini
