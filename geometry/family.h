#pragma once

#include <memory>

#include "geometry/axis.h"
#include "geometry/column.h"

namespace dini {

/// Values over named axes, row-major, the last axis fastest. One value is a family over no axes.
template <class T>
struct Family {
  Axes axes;
  Column<T> values;
};

template <class T>
using SharedFamily = std::shared_ptr<const Family<T>>;

/// The family over no axes that holds `value`.
template <class T>
SharedFamily<T> single(T value) {
  auto family = std::make_shared<Family<T>>();
  family->values = Column<T>(1);
  family->values.set(0, std::move(value));
  return family;
}

}  // namespace dini
