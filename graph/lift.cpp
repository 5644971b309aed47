#include "graph/lift.h"

#include <algorithm>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace dini {

void FirstFailure::report(std::size_t index, Failure failure) {
  const std::lock_guard lock(mutex_);
  if (index >= index_) return;
  index_ = index;
  failure_ = std::move(failure);
}

void run_chunks(const Call& call, std::size_t grain, const FirstFailure& first,
                const std::function<void(std::size_t, std::size_t)>& work) {
  const std::size_t count = sample_count(call.lifted);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
    for (std::size_t begin = range.begin(); begin < range.end(); begin += grain) {
      if (call.context.cancel().stopped() || first.index() <= begin) return;
      work(begin, std::min(begin + grain, range.end()));
    }
  });
}

ChunkReaders::ChunkReaders(const Call& call, const PortBindings& bindings, void* first, void* inputs) {
  entries_.reserve(bindings.size());
  for (const PortBinding& binding : bindings) {
    entries_.push_back({binding.reader(call, binding.port), binding.member ? binding.member(inputs) : first});
  }
}

void ChunkReaders::begin_run(std::size_t begin, std::size_t end) {
  varying_.clear();
  for (const Entry& entry : entries_) {
    entry.reader->begin_run(begin, end, entry.target);
    if (entry.reader->varies()) varying_.push_back(&entry);
  }
}

void ChunkReaders::read(std::size_t index) const {
  for (const Entry* entry : varying_) entry->reader->read(index, entry->target);
}

bool ChunkReaders::same(std::size_t a, std::size_t b) const {
  return std::all_of(varying_.begin(), varying_.end(), [&](const Entry* entry) { return entry->reader->same(a, b); });
}

}  // namespace dini
