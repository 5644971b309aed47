#include "graph/value.h"

#include <algorithm>

#include "geometry/chunks.h"
#include "graph/offsets.h"

namespace dini {

namespace {

template <class T>
std::size_t held_by(const Column<T>& column) {
  std::size_t total = column.bytes();
  if constexpr (std::is_same_v<T, SharedMesh>) {
    for (std::size_t i = 0; i < column.size(); ++i) total += column[i]->bytes();
  }
  if constexpr (std::is_same_v<T, SharedFile>) {
    for (std::size_t i = 0; i < column.size(); ++i) total += column[i]->bytes->size();
  }
  if constexpr (std::is_same_v<T, SharedField>) {
    for (std::size_t i = 0; i < column.size(); ++i) total += column[i]->size().bytes;
  }
  return total;
}

template <class T>
AnyColumn stack_columns(const std::vector<Value>& items, const Axes& axes, const Cancel& cancel) {
  auto stacked = std::make_shared<Column<T>>(sample_count(axes));
  const Axes shared(axes.begin(), axes.end() - 1);
  const std::size_t inner = items.size();
  const std::size_t outer = sample_count(shared);
  for (std::size_t item = 0; item < inner; ++item) {
    const Column<T>& source = column_of<T>(items[item]);
    const Offsets offsets(items[item].axes, shared);
    for_chunks(cancel, outer, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) stacked->set(i * inner + item, source[offsets.at(i)]);
    });
  }
  return SharedColumn<T>(std::move(stacked));
}

}  // namespace

std::size_t bytes(const AnyColumn& column) {
  return std::visit([](const auto& shared) { return held_by(*shared); }, column);
}

Value stack(const std::vector<Value>& items, const Axis& axis, const Cancel& cancel) {
  Axes axes;
  for (const Value& item : items) {
    for (const Axis& own : item.axes) {
      const bool known = std::any_of(axes.begin(), axes.end(), [&](const Axis& a) { return a.name == own.name; });
      if (!known) axes.push_back(own);
    }
  }
  axes.push_back(axis);
  return std::visit(
      [&]<class T>(const std::shared_ptr<const Column<T>>&) {
        return Value{axes, stack_columns<T>(items, axes, cancel)};
      },
      items.front().column);
}

}  // namespace dini
