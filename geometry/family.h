#pragma once

#include <memory>
#include <utility>

#include "geometry/axis.h"
#include "geometry/column.h"

namespace dini {

template <class T>
using SharedColumn = std::shared_ptr<const Column<T>>;

/// Values over named axes, row-major, the last axis fastest. One value is a family over no axes.
/// The values are shared and never change; copying a family copies its axes only.
template <class T>
struct Family {
  Axes axes;
  SharedColumn<T> values;
};

/// The column that holds one value.
template <class T>
SharedColumn<T> single_column(T value) {
  auto column = std::make_shared<Column<T>>(1);
  column->set(0, std::move(value));
  return column;
}

/// The family over no axes that holds `value`.
template <class T>
Family<T> single(T value) {
  return {{}, single_column<T>(std::move(value))};
}

}  // namespace dini
