#pragma once

// Lifting: running a plain function of single values over the union of its inputs' axes.
//
// A function may return
//   T                     one value of a wire type per run
//   Made<T>               all values along the axes that the node makes
//   std::tuple<...>       several outputs, each of the above
//   Attempt<any of these> the same, or a Failure
//   std::optional<Failure>, or void, when it writes through BatchOut parameters
// Runs are independent and spread over threads; which thread does what never shows in the result.
// graph/lift_single.h and graph/lift_batched.h have the two ways in which functions run.

#include <atomic>
#include <functional>
#include <limits>
#include <mutex>
#include <tuple>

#include "graph/port_reader.h"

namespace dini {

/// All values along the axes that a node makes, in row-major order.
template <WireValue T>
struct Made {
  Column<T> values;
};

template <class T>
using Attempt = Expected<T, Failure>;

/// The failure of a run and the loop index at which it happened.
struct FailedRun {
  Failure failure;
  std::size_t index = 0;
};

using LiftedResult = Expected<std::vector<AnyColumn>, FailedRun>;

/// One output of a function.
struct OutputSlot {
  WireType type = WireType::number;
  bool makes_axes = false;
};

/// Where an input goes: into the first value of a function, or into a member of its inputs.
struct PortBinding {
  std::size_t port = 0;
  MakeReader reader = nullptr;
  std::function<void*(void* inputs)> member;  ///< absent for the first value
};
using PortBindings = std::vector<PortBinding>;

/// The failure with the lowest index, so that the answer does not depend on threads.
class FirstFailure {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  void report(std::size_t index, Failure failure);
  /// The lowest index at which something failed so far.
  std::size_t index() const { return index_; }
  const Failure& failure() const { return failure_; }

 private:
  std::atomic<std::size_t> index_ = none;
  Failure failure_;
  std::mutex mutex_;
};

/// Runs `work(begin, end)` over all lifted indices in chunks of `grain`, and stops when the call is canceled or an
/// earlier index has failed.
void run_chunks(const Call& call, std::size_t grain, const FirstFailure& first,
                const std::function<void(std::size_t begin, std::size_t end)>& work);

/// The readers of one chunk, each with the place that it writes to.
class ChunkReaders {
 public:
  /// `first` is where the first value of a function is taken from, `inputs` its struct of inputs.
  ChunkReaders(const Call& call, const PortBindings& bindings, void* first, void* inputs);

  void begin_run(std::size_t begin, std::size_t end);
  /// Reads what differs from index to index of a run.
  void read(std::size_t index) const;
  /// Whether everything that differs is the same at two indices.
  bool same(std::size_t a, std::size_t b) const;
  bool varies() const { return !varying_.empty(); }

 private:
  struct Entry {
    std::unique_ptr<PortReader> reader;
    void* target;
  };
  std::vector<Entry> entries_;
  std::vector<const Entry*> varying_;
};

/// The parameters of a node function, told apart by their types.
struct Nothing {};
template <class T>
inline constexpr bool is_out = false;
template <class T>
inline constexpr bool is_out<BatchOut<T>> = true;
template <class T>
concept InputStruct = std::is_class_v<T> && !ArgumentType<T> && !is_out<T> && !std::is_same_v<T, Context>;

template <class... A>
struct Roles {
  using First = Nothing;
  using Inputs = Nothing;
  using Outs = std::tuple<>;
  static constexpr bool has_context = false;
};
template <class A, class... Rest>
struct Roles<A, Rest...> {
  using Next = Roles<Rest...>;
  using First = std::conditional_t<ArgumentType<A>, A, typename Next::First>;
  using Inputs = std::conditional_t<InputStruct<A>, A, typename Next::Inputs>;
  using Outs =
      decltype(std::tuple_cat(std::conditional_t<is_out<A>, std::tuple<A>, std::tuple<>>{}, typename Next::Outs{}));
  static constexpr bool has_context = std::is_same_v<A, Context> || Next::has_context;
  static_assert(!ArgumentType<A> || std::is_same_v<typename Next::First, Nothing>,
                "a function has one value of its own; the others are members of its inputs, by name");
  static_assert(!InputStruct<A> || std::is_same_v<typename Next::Inputs, Nothing>,
                "a function has one struct of inputs");
};

/// What a function of these roles is called with; the readers write into it.
template <class Role>
struct Given {
  const Context& context;
  typename Role::First first{};
  typename Role::Inputs inputs{};
  typename Role::Outs outs{};

  /// The parameter of type P.
  template <class P>
  const P& as() const {
    if constexpr (std::is_same_v<P, Context>) {
      return context;
    } else if constexpr (std::is_same_v<P, typename Role::First>) {
      return first;
    } else if constexpr (is_out<P>) {
      return std::get<P>(outs);
    } else {
      return inputs;
    }
  }
};

/// One output by the type that a function returns.
template <class R>
struct OutputTraits {
  using Element = R;
  static constexpr bool makes_axes = false;
};
template <WireValue T>
struct OutputTraits<Made<T>> {
  using Element = T;
  static constexpr bool makes_axes = true;
};

template <class... R>
std::vector<OutputSlot> slots_of(std::type_identity<std::tuple<R...>>) {
  return {OutputSlot{Wire<typename OutputTraits<R>::Element>::type, OutputTraits<R>::makes_axes}...};
}

template <class T>
AnyColumn shared(Column<T> column) {
  return SharedColumn<T>(std::make_shared<Column<T>>(std::move(column)));
}

/// The finished columns, or the failure that comes first.
template <class... T>
LiftedResult finished(std::tuple<Column<T>...>& columns, const FirstFailure& first) {
  if (first.index() != FirstFailure::none) return FailedRun{first.failure(), first.index()};
  std::vector<AnyColumn> result;
  std::apply([&](auto&... column) { (result.push_back(shared(std::move(column))), ...); }, columns);
  return result;
}

}  // namespace dini
