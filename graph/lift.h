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

#include <atomic>
#include <limits>
#include <mutex>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tuple>
#include <variant>

#include "graph/arguments.h"

namespace dini {

/// All values along the axes that a node makes, in row-major order.
template <WireValue T>
struct Made {
  Column<T> values;
};

template <class T>
using Attempt = std::variant<T, Failure>;

/// The failure of a run and the loop index at which it happened.
struct FailedRun {
  Failure failure;
  std::size_t index = 0;
};

using LiftedResult = std::variant<std::vector<AnyColumn>, FailedRun>;

// ---------------------------------------------------------------------------------------------------------------------

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

/// Every return type as a tuple of outputs.
template <class R>
struct Outputs {
  using Tuple = std::tuple<R>;
};
template <class... R>
struct Outputs<std::tuple<R...>> {
  using Tuple = std::tuple<R...>;
};
template <class R>
struct Outputs<Attempt<R>> : Outputs<R> {};

/// The BatchOut parameters of a function as a tuple of outputs.
template <class... A>
struct BatchOutputs;
template <>
struct BatchOutputs<> {
  using Tuple = std::tuple<>;
};
template <class First, class... Rest>
struct BatchOutputs<First, Rest...> : BatchOutputs<Rest...> {};
template <class T, class... Rest>
struct BatchOutputs<BatchOut<T>, Rest...> {
  using Tuple = decltype(std::tuple_cat(std::tuple<T>{}, typename BatchOutputs<Rest...>::Tuple{}));
};

template <class T>
inline constexpr bool is_attempt = false;
template <class T>
inline constexpr bool is_attempt<Attempt<T>> = true;

template <class A>
constexpr bool takes_port =
    ArgumentTraits<A>::kind != ArgumentKind::context&& ArgumentTraits<A>::kind != ArgumentKind::out;

/// A node function with its types: knows how to run itself over a call.
template <class R, class... A>
class LiftedFunction {
 public:
  using Function = R (*)(A...);
  static constexpr bool batched = ((ArgumentTraits<std::remove_cvref_t<A>>::kind == ArgumentKind::out) || ...);
  using OutputTuple = typename std::conditional_t<batched, BatchOutputs<std::remove_cvref_t<A>...>,
                                                  Outputs<std::conditional_t<batched, int, R>>>::Tuple;
  static constexpr std::size_t output_count = std::tuple_size_v<OutputTuple>;

  /// A function that looks at the flag may take long for one run.
  static constexpr bool looks_itself = ((ArgumentTraits<std::remove_cvref_t<A>>::kind == ArgumentKind::context) || ...);

  explicit LiftedFunction(Function function) : function_(function) {}

  LiftedResult operator()(const Call& call) const {
    const std::size_t count = sample_count(call.lifted);
    auto columns = make_columns(call, count, std::make_index_sequence<output_count>{});
    FirstFailure first;
    const std::size_t grain = batched ? 4096 : 64;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
      for (std::size_t begin = range.begin(); begin < range.end(); begin += grain) {
        if (call.context.cancel().stopped() || first.index <= begin) return;
        const std::size_t end = std::min(begin + grain, range.end());
        run(call, begin, end, columns, first, std::index_sequence_for<A...>{});
      }
    });
    if (first.index != none) return FailedRun{first.failure, first.index};
    std::vector<AnyColumn> result;
    std::apply([&](auto&... column) { (result.push_back(share(std::move(column))), ...); }, columns);
    return result;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  struct FirstFailure {
    std::atomic<std::size_t> index = none;
    Failure failure;
    std::mutex mutex;

    /// Keeps the failure with the lowest index, so that the answer does not depend on threads.
    void report(std::size_t at, Failure what) {
      const std::lock_guard lock(mutex);
      if (at >= index) return;
      index = at;
      failure = std::move(what);
    }
  };

  template <class T>
  static AnyColumn share(Column<T> column) {
    return SharedColumn<T>(std::make_shared<Column<T>>(std::move(column)));
  }

  template <std::size_t... O>
  static auto make_columns(const Call& call, std::size_t count, std::index_sequence<O...>) {
    return std::make_tuple(Column<typename OutputTraits<std::tuple_element_t<O, OutputTuple>>::Element>(
        size_of_column<std::tuple_element_t<O, OutputTuple>>(count, call.made[O]))...);
  }

  /// Of a column that waits for its values; what the only run makes becomes the column itself.
  template <class Output>
  static std::size_t size_of_column(std::size_t count, const Axes& made) {
    return OutputTraits<Output>::makes_axes && count == 1 ? 0 : count * sample_count(made);
  }

  /// The port that parameter `index` reads: parameters that are no ports do not count.
  static constexpr std::size_t port_of(std::size_t index) {
    constexpr std::array<bool, sizeof...(A)> ports = {takes_port<std::remove_cvref_t<A>>...};
    std::size_t port = 0;
    for (std::size_t k = 0; k < index; ++k) port += ports[k] ? 1 : 0;
    return port;
  }

  template <class P>
  struct OutReader {  // stands where a BatchOut parameter stands; filled per run
    OutReader(const Call&, std::size_t) {}
    void begin_run(std::size_t, std::size_t) {}
  };

  template <class P>
  using ReaderOf = typename std::conditional_t<ArgumentTraits<P>::kind == ArgumentKind::out,
                                               std::type_identity<OutReader<P>>, std::type_identity<Reader<P>>>::type;

  template <class Columns, std::size_t... I>
  void run(const Call& call, std::size_t begin, std::size_t end, Columns& columns, FirstFailure& first,
           std::index_sequence<I...>) const {
    std::tuple<ReaderOf<std::remove_cvref_t<A>>...> readers{ReaderOf<std::remove_cvref_t<A>>(call, port_of(I))...};
    if constexpr (batched) {
      (std::get<I>(readers).begin_run(begin, end), ...);
      // A run ends where a parameter that is no batch changes. All ends are found first: beginning a run moves the
      // readers.
      std::vector<std::size_t> ends;
      for (std::size_t index = begin + 1; index < end; ++index) {
        if (!(same_place(std::get<I>(readers), index - 1, index) && ...)) ends.push_back(index);
      }
      ends.push_back(end);
      for (const std::size_t stop : ends) {
        if (ends.size() > 1) (std::get<I>(readers).begin_run(begin, stop), ...);
        if constexpr (std::is_void_v<R>) {
          function_(batch_argument<std::remove_cvref_t<A>, I>(std::get<I>(readers), begin, stop, columns)...);
        } else if (auto failure = function_(
                       batch_argument<std::remove_cvref_t<A>, I>(std::get<I>(readers), begin, stop, columns)...)) {
          first.report(begin, std::move(*failure));
          return;
        }
        begin = stop;
      }
    } else {
      (std::get<I>(readers).begin_run(begin, end), ...);
      for (std::size_t index = begin; index < end; ++index) {
        if (looks_itself && call.context.cancel().stopped()) return;
        store(function_(std::get<I>(readers).get(index)...), index, columns, first);
      }
    }
  }

  template <class Reading>
  static bool same_place(const Reading& reader, std::size_t a, std::size_t b) {
    if constexpr (requires { reader.place(a); }) {
      return reader.place(a) == reader.place(b);
    } else {
      return true;
    }
  }

  template <class P, std::size_t I, class Reading, class Columns>
  static decltype(auto) batch_argument(Reading& reader, std::size_t begin, std::size_t end, Columns& columns) {
    if constexpr (ArgumentTraits<P>::kind == ArgumentKind::out) {
      constexpr std::size_t output = I - (sizeof...(A) - output_count);
      auto& column = std::get<output>(columns);
      P out{{}, end - begin};
      for (std::size_t k = 0; k < out.components.size(); ++k) out.components[k] = column.component(k) + begin;
      return out;
    } else {
      return reader.get(begin);
    }
  }

  template <class V, class Columns>
  static void store(V&& result, std::size_t index, Columns& columns, FirstFailure& first) {
    using Plain = std::remove_cvref_t<V>;
    if constexpr (is_attempt<Plain>) {
      if (auto* failure = std::get_if<Failure>(&result)) {
        first.report(index, std::move(*failure));
      } else {
        store(std::get<0>(std::forward<V>(result)), index, columns, first);
      }
    } else if constexpr (requires { std::tuple_size<Plain>::value; }) {
      store_tuple(std::forward<V>(result), index, columns, std::make_index_sequence<output_count>{});
    } else {
      store_one(std::forward<V>(result), index, std::get<0>(columns));
    }
  }

  template <class T, class Columns, std::size_t... O>
  static void store_tuple(T&& results, std::size_t index, Columns& columns, std::index_sequence<O...>) {
    (store_one(std::get<O>(std::forward<T>(results)), index, std::get<O>(columns)), ...);
  }

  template <class T>
  static void store_one(T value, std::size_t index, Column<T>& column) {
    column.set(index, std::move(value));
  }
  template <class T>
  static void store_one(Made<T> made, std::size_t index, Column<T>& column) {
    const std::size_t size = made.values.size();
    if (column.empty()) {  // the only run
      column = std::move(made.values);
      return;
    }
    for (std::size_t i = 0; i < size; ++i) column.set(index * size + i, made.values[i]);
  }

  Function function_;
};

}  // namespace dini
