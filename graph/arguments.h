#pragma once

// What the parameters of a node function may be, and how each is read while the engine runs the function over the
// lifted axes.
//
//   const T&            one value of a wire type: the function is lifted over its axes
//   std::optional<T>    the same, for an input that may be left out
//   Block<T, K>         all values along the K axes that the node consumes, for one index of the remaining axes
//   Batch<T>            a run of values at once, as component arrays, for functions that call SIMD kernels
//   BatchOut<T>         where such a function writes its results
//   std::int64_t, bool, std::string, Color, or an enum with ChoiceNames      a literal written in the graph
//   SharedAssetFile        a mesh file, which the graph names by a literal text
//   Several<types...>   all values of an input that takes several, of any of these types, with all their axes
//   const Context&      the evaluation itself; first, if at all

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

/// All values of an input along the consumed axes. An input that lacks one is constant along it.
template <WireValue T, int K>
class Block {
 public:
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

 private:
  const Column<T>* column_;
  std::size_t base_;
  const Axes* consumed_;
  std::array<std::size_t, K> strides_{};
};

/// `size` values as component arrays; when `constant`, one value that stands for all of them.
template <WireValue T>
struct Batch {
  std::array<const double*, Components<T>::width> components;
  std::size_t size;
  bool constant;

  T operator[](std::size_t i) const {
    std::array<double, Components<T>::width> one{};
    for (std::size_t k = 0; k < one.size(); ++k) one[k] = components[k][constant ? 0 : i];
    return Components<T>::get(one.data(), 1);
  }
};

template <WireValue T>
struct BatchOut {
  std::array<double*, Components<T>::width> components;
  std::size_t size;

  void set(std::size_t i, const T& value) const {
    std::array<double, Components<T>::width> one{};
    Components<T>::set(one.data(), 1, value);
    for (std::size_t k = 0; k < one.size(); ++k) components[k][i] = one[k];
  }
};

// ---------------------------------------------------------------------------------------------------------------------

/// How an argument type is described on a card.
enum class ArgumentKind { context, value, optional, block, batch, out, literal, mixed };

template <class A>
struct ArgumentTraits;

template <>
struct ArgumentTraits<Context> {
  static constexpr ArgumentKind kind = ArgumentKind::context;
};
template <WireValue T>
struct ArgumentTraits<T> {
  static constexpr ArgumentKind kind = ArgumentKind::value;
  static constexpr WireType type = Wire<T>::type;
};
template <WireValue T>
struct ArgumentTraits<std::optional<T>> {
  static constexpr ArgumentKind kind = ArgumentKind::optional;
  static constexpr WireType type = Wire<T>::type;
};
template <WireValue T, int K>
struct ArgumentTraits<Block<T, K>> {
  static constexpr ArgumentKind kind = ArgumentKind::block;
  static constexpr WireType type = Wire<T>::type;
  static constexpr int rank = K;
};
template <WireValue T>
struct ArgumentTraits<Batch<T>> {
  static constexpr ArgumentKind kind = ArgumentKind::batch;
  static constexpr WireType type = Wire<T>::type;
};
template <WireValue T>
struct ArgumentTraits<BatchOut<T>> {
  static constexpr ArgumentKind kind = ArgumentKind::out;
};
template <WireType... Types>
struct ArgumentTraits<Several<Types...>> {
  static constexpr ArgumentKind kind = ArgumentKind::mixed;
  static constexpr std::array types = {Types...};
};
template <WireType Type>
struct LiteralTraits {
  static constexpr ArgumentKind kind = ArgumentKind::literal;
  static constexpr WireType type = Type;
};
template <>
struct ArgumentTraits<std::int64_t> : LiteralTraits<WireType::integer> {};
template <>
struct ArgumentTraits<bool> : LiteralTraits<WireType::boolean> {};
template <>
struct ArgumentTraits<std::string> : LiteralTraits<WireType::text> {};
template <>
struct ArgumentTraits<Color> : LiteralTraits<WireType::color> {};
template <>
struct ArgumentTraits<SharedAssetFile> : LiteralTraits<WireType::text> {};
template <ChoiceEnum E>
struct ArgumentTraits<E> : LiteralTraits<WireType::choice> {};

// ---------------------------------------------------------------------------------------------------------------------

/// Reads one parameter of a function during a run over loop indices: `begin_run` once per run, then `get` per index.
template <class A>
class Reader;

template <>
class Reader<Context> {
 public:
  Reader(const Call& call, std::size_t) : context_(call.context) {}
  void begin_run(std::size_t, std::size_t) {}
  const Context& get(std::size_t) const { return context_; }

 private:
  const Context& context_;
};

template <WireValue T>
class Reader<T> {
 public:
  Reader(const Call& call, std::size_t port)
      : value_(std::get<Value>(call.arguments[port])),
        column_(column_of<T>(value_)),
        offsets_(value_.axes, call.lifted) {}

  void begin_run(std::size_t begin, std::size_t end) {
    begin_ = begin;
    if (!offsets_.constant() && !offsets_.contiguous()) offsets_.fill(begin, end, places_);
  }
  std::size_t place(std::size_t index) const {
    return offsets_.constant() ? 0 : offsets_.contiguous() ? index : places_[index - begin_];
  }
  T get(std::size_t index) const { return column_[place(index)]; }
  const Value& value() const { return value_; }
  const Column<T>& column() const { return column_; }

 private:
  const Value& value_;
  const Column<T>& column_;
  Offsets offsets_;
  std::size_t begin_ = 0;
  std::vector<std::size_t> places_;
};

template <WireValue T>
class Reader<std::optional<T>> {
 public:
  Reader(const Call& call, std::size_t port) {
    if (std::holds_alternative<Value>(call.arguments[port])) reader_.emplace(call, port);
  }
  void begin_run(std::size_t begin, std::size_t end) {
    if (reader_) reader_->begin_run(begin, end);
  }
  std::size_t place(std::size_t index) const { return reader_ ? reader_->place(index) : 0; }
  std::optional<T> get(std::size_t index) const {
    return reader_ ? std::optional<T>(reader_->get(index)) : std::nullopt;
  }

 private:
  std::optional<Reader<T>> reader_;
};

template <WireValue T, int K>
class Reader<Block<T, K>> {
 public:
  Reader(const Call& call, std::size_t port) : reader_(call, port), consumed_(call.consumed) {}
  void begin_run(std::size_t begin, std::size_t end) { reader_.begin_run(begin, end); }
  std::size_t place(std::size_t index) const { return reader_.place(index); }
  Block<T, K> get(std::size_t index) const {
    return {reader_.column(), reader_.place(index), reader_.value().axes, consumed_};
  }

 private:
  Reader<T> reader_;
  const Axes& consumed_;
};

template <WireValue T>
class Reader<Batch<T>> {
 public:
  static constexpr std::size_t width = Components<T>::width;

  Reader(const Call& call, std::size_t port)
      : column_(column_of<T>(std::get<Value>(call.arguments[port]))),
        offsets_(std::get<Value>(call.arguments[port]).axes, call.lifted) {}

  void begin_run(std::size_t begin, std::size_t end) {
    size_ = end - begin;
    begin_ = begin;
    if (offsets_.constant() || offsets_.contiguous()) return;
    offsets_.fill(begin, end, places_);
    gathered_.resize(width * size_);
    for (std::size_t k = 0; k < width; ++k) {
      const double* source = column_.component(k);
      double* target = gathered_.data() + k * size_;
      for (std::size_t i = 0; i < size_; ++i) target[i] = source[places_[i]];
    }
  }
  Batch<T> get(std::size_t) const {
    Batch<T> batch{{}, size_, offsets_.constant()};
    for (std::size_t k = 0; k < width; ++k) {
      batch.components[k] = offsets_.constant()     ? column_.component(k)
                            : offsets_.contiguous() ? column_.component(k) + begin_
                                                    : gathered_.data() + k * size_;
    }
    return batch;
  }

 private:
  const Column<T>& column_;
  Offsets offsets_;
  std::size_t begin_ = 0;
  std::size_t size_ = 0;
  std::vector<std::size_t> places_;
  std::vector<double> gathered_;
};

template <class L>
requires(ArgumentTraits<L>::kind == ArgumentKind::literal) class Reader<L> {
 public:
  Reader(const Call& call, std::size_t port) {
    const Literal& literal = std::get<Literal>(call.arguments[port]);
    if constexpr (ChoiceEnum<L>) {
      const std::string& word = std::get<std::string>(literal);
      for (std::size_t k = 0; k < ChoiceNames<L>::names.size(); ++k) {
        if (ChoiceNames<L>::names[k] == word) value_ = static_cast<L>(k);
      }
    } else {
      value_ = std::get<L>(literal);
    }
  }
  void begin_run(std::size_t, std::size_t) {}
  const L& get(std::size_t) const { return value_; }

 private:
  L value_{};
};

template <WireType... Types>
class Reader<Several<Types...>> {
 public:
  Reader(const Call& call, std::size_t port) : several_{std::get<Items>(call.arguments[port])} {}
  void begin_run(std::size_t, std::size_t) {}
  const Several<Types...>& get(std::size_t) const { return several_; }

 private:
  Several<Types...> several_;
};

}  // namespace dini
