#include "graph/offsets.h"

#include <algorithm>

namespace dini {

std::size_t stride_of(const Axes& axes, const std::string& name) {
  std::size_t stride = 1;
  for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
    if (axis->name == name) return stride;
    stride *= axis->size;
  }
  return 0;
}

Offsets::Offsets(const Axes& own, const Axes& loop) {
  for (const Axis& axis : loop) {
    sizes_.push_back(axis.size);
    strides_.push_back(stride_of(own, axis.name));
  }
  constant_ = std::all_of(strides_.begin(), strides_.end(), [](std::size_t stride) { return stride == 0; });
  contiguous_ = true;
  std::size_t expected = 1;
  for (std::size_t k = sizes_.size(); k-- > 0;) {
    contiguous_ = contiguous_ && strides_[k] == expected;
    expected *= sizes_[k];
  }
}

std::size_t Offsets::at(std::size_t index) const {
  std::size_t offset = 0;
  for (std::size_t k = sizes_.size(); k-- > 0;) {
    offset += index % sizes_[k] * strides_[k];
    index /= sizes_[k];
  }
  return offset;
}

void Offsets::fill(std::size_t begin, std::size_t end, std::vector<std::size_t>& out) const {
  out.clear();
  if (begin >= end) return;
  std::vector<std::size_t> position(sizes_.size());
  std::size_t rest = begin;
  for (std::size_t k = sizes_.size(); k-- > 0;) {
    position[k] = rest % sizes_[k];
    rest /= sizes_[k];
  }
  std::size_t offset = at(begin);
  for (std::size_t index = begin; index < end; ++index) {
    out.push_back(offset);
    for (std::size_t k = sizes_.size(); k-- > 0;) {
      offset += strides_[k];
      if (++position[k] < sizes_[k]) break;
      offset -= strides_[k] * sizes_[k];
      position[k] = 0;
    }
  }
}

}  // namespace dini
