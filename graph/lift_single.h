#pragma once

#include "graph/lift.h"

namespace dini {

/// What a function returns, as a tuple of outputs.
template <class R>
struct Returned {
  using Tuple = std::tuple<R>;
  static constexpr bool is_attempt = false;
};
template <class... R>
struct Returned<std::tuple<R...>> {
  using Tuple = std::tuple<R...>;
  static constexpr bool is_attempt = false;
};
template <class R>
struct Returned<Attempt<R>> : Returned<R> {
  static constexpr bool is_attempt = true;
};

/// A function of single values: called once for every lifted index.
template <class R, class... A>
class SingleFunction {
 public:
  using Function = R (*)(A...);
  using Role = Roles<std::remove_cvref_t<A>...>;
  using Outputs = typename Returned<R>::Tuple;

  explicit SingleFunction(Function function) : function_(function) {}

  LiftedResult operator()(const Call& call, const PortBindings& bindings) const {
    constexpr std::size_t grain = 64;
    const std::size_t count = sample_count(call.lifted);
    auto columns = make_columns(call, count, std::make_index_sequence<std::tuple_size_v<Outputs>>{});
    FirstFailure first;
    run_chunks(call, grain, first,
               [&](std::size_t begin, std::size_t end) { run(call, bindings, begin, end, columns, first); });
    return finished(columns, first);
  }

 private:
  template <class Columns>
  void run(const Call& call, const PortBindings& bindings, std::size_t begin, std::size_t end, Columns& columns,
           FirstFailure& first) const {
    Given<Role> given{call.context};
    ChunkReaders readers(call, bindings, &given.first, &given.inputs);
    readers.begin_run(begin, end);
    for (std::size_t index = begin; index < end; ++index) {
      // A function that looks at the flag may take long for one run.
      if (Role::has_context && call.context.cancel().stopped()) return;
      readers.read(index);
      store(function_(given.template as<std::remove_cvref_t<A>>()...), index, columns, first);
    }
  }

  template <std::size_t... O>
  static auto make_columns(const Call& call, std::size_t count, std::index_sequence<O...>) {
    return std::make_tuple(Column<typename OutputTraits<std::tuple_element_t<O, Outputs>>::Element>(
        size_of_column<std::tuple_element_t<O, Outputs>>(count, call.made[O]))...);
  }

  /// Of a column that waits for its values; what the only run makes becomes the column itself.
  template <class Output>
  static std::size_t size_of_column(std::size_t count, const Axes& made) {
    return OutputTraits<Output>::makes_axes && count == 1 ? 0 : count * sample_count(made);
  }

  template <class V, class Columns>
  static void store(V&& result, std::size_t index, Columns& columns, FirstFailure& first) {
    using Plain = std::remove_cvref_t<V>;
    if constexpr (Returned<Plain>::is_attempt) {
      if (result) {
        store(*std::forward<V>(result), index, columns, first);
      } else {
        first.report(index, std::forward<V>(result).error());
      }
    } else if constexpr (requires { std::tuple_size<Plain>::value; }) {
      store_all(std::forward<V>(result), index, columns, std::make_index_sequence<std::tuple_size_v<Outputs>>{});
    } else {
      store_one(std::forward<V>(result), index, std::get<0>(columns));
    }
  }

  template <class T, class Columns, std::size_t... O>
  static void store_all(T&& results, std::size_t index, Columns& columns, std::index_sequence<O...>) {
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
