#pragma once

// Columns: the storage behind every family. Elements made of numbers (points, vectors, generators, circles) are kept as
// one array of doubles per component, so that kernels read them with SIMD; everything else is a plain array.

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "algebra/elements.h"
#include "geometry/zeroed.h"

namespace dini {

/// How an element splits into numbers: `width` components, `get` and `set` against component arrays.
/// `base[k * stride]` is component k. Specialized for every element made of numbers.
template <class T>
struct Components {
  static constexpr std::size_t width = 0;
};

template <>
struct Components<double> {
  static constexpr std::size_t width = 1;
  static double get(const double* base, std::size_t) { return *base; }
  static void set(double* base, std::size_t, double value) { *base = value; }
};

template <>
struct Components<Vector> {
  static constexpr std::size_t width = 3;
  static Vector get(const double* base, std::size_t stride) { return {base[0], base[stride], base[2 * stride]}; }
  static void set(double* base, std::size_t stride, const Vector& value) {
    base[0] = value.x;
    base[stride] = value.y;
    base[2 * stride] = value.z;
  }
};

template <>
struct Components<Point> {
  static constexpr std::size_t width = 3;
  static Point get(const double* base, std::size_t stride) { return to_point(Components<Vector>::get(base, stride)); }
  static void set(double* base, std::size_t stride, const Point& value) {
    Components<Vector>::set(base, stride, to_vector(value));
  }
};

/// Order of the ten components: no_e x y z, e_e x y z, no_ni, e_ni x y z.
template <>
struct Components<Generator> {
  static constexpr std::size_t width = 10;
  static Generator get(const double* base, std::size_t stride) {
    return {Components<Vector>::get(base, stride), Components<Vector>::get(base + 3 * stride, stride), base[6 * stride],
            Components<Vector>::get(base + 7 * stride, stride)};
  }
  static void set(double* base, std::size_t stride, const Generator& value) {
    Components<Vector>::set(base, stride, value.no_e);
    Components<Vector>::set(base + 3 * stride, stride, value.e_e);
    base[6 * stride] = value.no_ni;
    Components<Vector>::set(base + 7 * stride, stride, value.e_ni);
  }
};

template <>
struct Components<Circle> {
  static constexpr std::size_t width = 10;
  static Circle get(const double* base, std::size_t stride) { return {Components<Generator>::get(base, stride)}; }
  static void set(double* base, std::size_t stride, const Circle& value) {
    Components<Generator>::set(base, stride, value.dual);
  }
};

template <>
struct Components<Sphere> {
  static constexpr std::size_t width = 5;
  static Sphere get(const double* base, std::size_t stride) {
    return {base[0], Components<Vector>::get(base + stride, stride), base[4 * stride]};
  }
  static void set(double* base, std::size_t stride, const Sphere& value) {
    base[0] = value.no;
    Components<Vector>::set(base + stride, stride, value.e);
    base[4 * stride] = value.ni;
  }
};

/// `size` elements of one type. Elements made of numbers are stored component by component.
template <class T>
class Column {
 public:
  using value_type = T;
  static constexpr bool numeric = Components<T>::width > 0;
  static constexpr std::size_t width = Components<T>::width;

  Column() = default;
  explicit Column(std::size_t size) : size_(size), data_(numeric ? width * size : size) {}
  /// Elements that may hold anything, where all of them are written before one is read.
  static Column unwritten(std::size_t size) {
    if constexpr (numeric) {
      Column column;
      column.size_ = size;
      column.data_ = Zeroed<double>::unwritten(width * size);
      return column;
    } else {
      return Column(size);
    }
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  T operator[](std::size_t index) const {
    if constexpr (numeric) {
      return Components<T>::get(data_.data() + index, size_);
    } else {
      return data_[index];
    }
  }

  void set(std::size_t index, T value) {
    if constexpr (numeric) {
      Components<T>::set(data_.data() + index, size_, value);
    } else {
      data_[index] = std::move(value);
    }
  }

  /// The array of component `k` of all elements; numeric elements only.
  const double* component(std::size_t k) const requires numeric { return data_.data() + k * size_; }
  double* component(std::size_t k) requires numeric { return data_.data() + k * size_; }

  std::size_t bytes() const { return data_.size() * sizeof(*data_.data()); }

  friend bool operator==(const Column& a, const Column& b) = default;

 private:
  std::size_t size_ = 0;
  std::conditional_t<numeric, Zeroed<double>, std::vector<T>> data_;
};

}  // namespace dini
