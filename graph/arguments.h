#pragma once

// What a node function is given.
//
// It takes, in this order and each at most once,
//   const Context&      the evaluation itself
//   a value             of the node's first input, the only one that differs between the functions of one node
//   const Inputs&       a struct of the node's own with a member for every other input; the card binds them by name
//   BatchOut<T>...      where a batched function writes its results
//
// The value and the members are each
//   T                   one value of a wire type: the function is lifted over its axes
//   std::optional<T>    the same, for an input that may be left out
//   Block<T, K>         all values along the K axes that the node consumes, for one index of the remaining axes
//   std::optional<Block<T, K>>      the same, for an input that may be left out or have fewer axes
//   Batch<T>            a run of values at once, as component arrays, for functions that call SIMD kernels
//   std::int64_t, bool, std::string, Color, or an enum with ChoiceNames      a literal written in the graph
//   SharedAssetFile     a mesh file, which the graph names by a literal text
//   Several<types...>   all values of an input that takes several, of any of these types, with all their axes

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "graph/context.h"
#include "graph/offsets.h"
#include "graph/value.h"

namespace dini {

/// The words of an enum that is a choice, in the order of its values: `static constexpr std::array names{...}`.
template <class E>
struct ChoiceNames;

template <class E>
concept ChoiceEnum = std::is_enum_v<E> && requires {
  ChoiceNames<E>::names.size();
};

/// All values of an input that takes several links, each of one of `Types`.
template <WireType... Types>
struct Several : Items {};

/// One evaluation of one node: what it receives and the axes involved.
struct Call {
  const Context& context;
  std::vector<Argument> arguments;  ///< one per port
  Axes lifted;                      ///< the function runs once for every index of these
  Axes consumed;                    ///< each run sees all of these at once
  std::vector<Axes> made;           ///< per output, the axes that each run adds
};

/// All values of an input along the consumed axes. An input that lacks one is constant along it; an axis that the
/// node's first block lacks too has one sample.
template <WireValue T, int K>
class Block {
 public:
  Block() = default;
  Block(const Column<T>& column, std::size_t base, const Axes& own, const Axes& consumed)
      : column_(&column), base_(base), consumed_(&consumed) {
    for (int k = 0; k < K; ++k) strides_[static_cast<std::size_t>(k)] = stride_of(own, axis(k).name);
  }

  const Axis& axis(int k = 0) const { return (*consumed_)[static_cast<std::size_t>(k)]; }
  std::size_t size(int k = 0) const { return axis(k).size; }

  T operator()(std::size_t i) const requires(K == 1) { return (*column_)[base_ + i * strides_[0]]; }
  T operator()(std::size_t i, std::size_t j) const requires(K == 2) {
    return (*column_)[base_ + i * strides_[0] + j * strides_[1]];
  }

  /// Where the values lie: (i, j) is column()[base() + i * stride(0) + j * stride(1)].
  const Column<T>& column() const { return *column_; }
  std::size_t base() const { return base_; }
  std::size_t stride(int k) const { return strides_[static_cast<std::size_t>(k)]; }

 private:
  const Column<T>* column_ = nullptr;
  std::size_t base_ = 0;
  const Axes* consumed_ = nullptr;
  std::array<std::size_t, K> strides_{};
};

/// `size` values as component arrays; when `constant`, one value that stands for all of them.
template <WireValue T>
struct Batch {
  std::array<const double*, Components<T>::width> components{};
  std::size_t size = 0;
  bool constant = false;

  T operator[](std::size_t i) const {
    std::array<double, Components<T>::width> one{};
    for (std::size_t k = 0; k < one.size(); ++k) one[k] = components[k][constant ? 0 : i];
    return Components<T>::get(one.data(), 1);
  }
};

template <WireValue T>
struct BatchOut {
  std::array<double*, Components<T>::width> components{};
  std::size_t size = 0;

  void set(std::size_t i, const T& value) const {
    std::array<double, Components<T>::width> one{};
    Components<T>::set(one.data(), 1, value);
    for (std::size_t k = 0; k < one.size(); ++k) components[k][i] = one[k];
  }
};

}  // namespace dini
