#pragma once

// Reading what arrives at one port while the engine runs a function over the lifted axes.

#include <memory>
#include <span>

#include "graph/arguments.h"

namespace dini {

/// How one function takes an input.
struct InputSlot {
  WireType type = WireType::number;     ///< the first of them where it takes several types
  std::vector<WireType> mixed = {};     ///< what an input that keeps its values apart takes; else empty
  std::vector<std::string> words = {};  ///< of a choice
  int consumed_axes = 0;                ///< of a Block
  bool optional = false;
  bool file = false;

  bool is_mixed() const { return !mixed.empty(); }
  bool is_block() const { return consumed_axes > 0; }
};

/// Writes what arrives at a port where a function takes it from, one run over some loop indices after another.
class PortReader {
 public:
  PortReader() = default;
  PortReader(const PortReader&) = delete;
  PortReader& operator=(const PortReader&) = delete;
  virtual ~PortReader() = default;

  /// Begins a run over the indices begin ... end - 1, and writes to `target` what is the same for all of them.
  virtual void begin_run(std::size_t begin, std::size_t end, void* target) = 0;

  /// Whether `read` has to be called for every index of the run.
  virtual bool varies() const { return false; }
  virtual void read(std::size_t, void*) const {}

  /// Whether `read` gives the same at two indices of the run.
  virtual bool same(std::size_t, std::size_t) const { return true; }
};

using MakeReader = std::unique_ptr<PortReader> (*)(const Call& call, std::size_t port);

template <class T>
std::unique_ptr<PortReader> read_value(const Call& call, std::size_t port);
template <class T>
std::unique_ptr<PortReader> read_optional(const Call& call, std::size_t port);
template <class T, int K>
std::unique_ptr<PortReader> read_block(const Call& call, std::size_t port);
template <class T, int K>
std::unique_ptr<PortReader> read_optional_block(const Call& call, std::size_t port);
template <class T>
std::unique_ptr<PortReader> read_batch(const Call& call, std::size_t port);
template <class L>
std::unique_ptr<PortReader> read_literal_of(const Call& call, std::size_t port);
std::unique_ptr<PortReader> read_items(const Call& call, std::size_t port);

/// The place of a choice among its words.
std::unique_ptr<PortReader> read_choice(const Call& call, std::size_t port, std::span<const std::string_view> words,
                                        void (*write)(void* target, std::size_t place));

/// For every type that a value or a member may have: how it is taken, and how it is read.
template <class A>
struct ArgumentTraits;

template <class A>
concept ArgumentType = requires {
  ArgumentTraits<A>::slot();
};

template <WireValue T>
struct ArgumentTraits<T> {
  static InputSlot slot() { return {Wire<T>::type}; }
  static constexpr MakeReader reader = read_value<T>;
};
template <WireValue T>
struct ArgumentTraits<std::optional<T>> {
  static InputSlot slot() { return {.type = Wire<T>::type, .optional = true}; }
  static constexpr MakeReader reader = read_optional<T>;
};
template <WireValue T, int K>
struct ArgumentTraits<Block<T, K>> {
  static InputSlot slot() { return {.type = Wire<T>::type, .consumed_axes = K}; }
  static constexpr MakeReader reader = read_block<T, K>;
};
template <WireValue T, int K>
struct ArgumentTraits<std::optional<Block<T, K>>> {
  static InputSlot slot() { return {.type = Wire<T>::type, .consumed_axes = K, .optional = true}; }
  static constexpr MakeReader reader = read_optional_block<T, K>;
};
template <WireValue T>
struct ArgumentTraits<Batch<T>> {
  static InputSlot slot() { return {Wire<T>::type}; }
  static constexpr MakeReader reader = read_batch<T>;
};
template <WireType... Types>
struct ArgumentTraits<Several<Types...>> {
  static InputSlot slot() {
    std::vector<WireType> types = {Types...};
    return {.type = types.front(), .mixed = types};
  }
  static constexpr MakeReader reader = read_items;
};
template <class L, WireType Type>
struct LiteralTraits {
  static InputSlot slot() { return {Type}; }
  static constexpr MakeReader reader = read_literal_of<L>;
};
template <>
struct ArgumentTraits<std::int64_t> : LiteralTraits<std::int64_t, WireType::integer> {};
template <>
struct ArgumentTraits<bool> : LiteralTraits<bool, WireType::boolean> {};
template <>
struct ArgumentTraits<std::string> : LiteralTraits<std::string, WireType::text> {};
template <>
struct ArgumentTraits<Color> : LiteralTraits<Color, WireType::color> {};
template <>
struct ArgumentTraits<SharedAssetFile> {
  static InputSlot slot() { return {.type = WireType::text, .file = true}; }
  static constexpr MakeReader reader = read_literal_of<SharedAssetFile>;
};
template <ChoiceEnum E>
struct ArgumentTraits<E> {
  static InputSlot slot() {
    return {.type = WireType::choice, .words = {ChoiceNames<E>::names.begin(), ChoiceNames<E>::names.end()}};
  }
  static std::unique_ptr<PortReader> reader(const Call& call, std::size_t port) {
    return read_choice(call, port, ChoiceNames<E>::names,
                       [](void* target, std::size_t place) { *static_cast<E*>(target) = static_cast<E>(place); });
  }
};

}  // namespace dini
