#pragma once

#include <utility>

#include "graph/lift.h"

namespace dini {

/// A function of batches: called once for every run of indices along which everything that is no batch stays the same.
template <class R, class... A>
class BatchedFunction {
 public:
  using Function = R (*)(A...);
  using Role = Roles<std::remove_cvref_t<A>...>;

  template <class... T>
  static std::tuple<T...> elements_of(std::type_identity<std::tuple<BatchOut<T>...>>);
  using Outputs = decltype(elements_of(std::type_identity<typename Role::Outs>{}));

  explicit BatchedFunction(Function function) : function_(function) {}

  LiftedResult operator()(const Call& call, const PortBindings& bindings) const {
    constexpr std::size_t grain = 4096;
    auto columns = make_columns(sample_count(call.lifted), std::type_identity<Outputs>{});
    FirstFailure first;
    run_chunks(call, grain, first,
               [&](std::size_t begin, std::size_t end) { run_chunk(call, bindings, begin, end, columns, first); });
    return finished(columns, first);
  }

 private:
  using Run = std::pair<std::size_t, std::size_t>;

  template <class Columns>
  void run_chunk(const Call& call, const PortBindings& bindings, std::size_t begin, std::size_t end, Columns& columns,
                 FirstFailure& first) const {
    Given<Role> given{call.context};
    ChunkReaders readers(call, bindings, &given.first, &given.inputs);
    readers.begin_run(begin, end);
    for (const Run& run : runs_of(readers, begin, end)) {
      if (call.context.cancel().stopped()) return;
      readers.begin_run(run.first, run.second);
      if (readers.varies()) readers.read(run.first);
      point_outs(run, columns, given.outs);
      if constexpr (std::is_void_v<R>) {
        function_(given.template as<std::remove_cvref_t<A>>()...);
      } else if (auto failure = function_(given.template as<std::remove_cvref_t<A>>()...)) {
        return first.report(run.first, std::move(*failure));
      }
    }
  }

  /// The runs of a chunk, found before any of them is begun.
  static std::vector<Run> runs_of(const ChunkReaders& readers, std::size_t begin, std::size_t end) {
    if (!readers.varies()) return {{begin, end}};
    std::vector<Run> runs;
    std::size_t from = begin;
    for (std::size_t index = begin + 1; index <= end; ++index) {
      if (index < end && readers.same(index - 1, index)) continue;
      runs.push_back({from, index});
      from = index;
    }
    return runs;
  }

  template <class... T>
  static std::tuple<Column<T>...> make_columns(std::size_t count, std::type_identity<std::tuple<T...>>) {
    return {Column<T>::unwritten(count)...};
  }

  template <class... T>
  static void point_outs(const Run& run, std::tuple<Column<T>...>& columns, std::tuple<BatchOut<T>...>& outs) {
    const auto point = [&]<class U>(Column<U>& column, BatchOut<U>& out) {
      out.size = run.second - run.first;
      for (std::size_t k = 0; k < out.components.size(); ++k) out.components[k] = column.component(k) + run.first;
    };
    (point(std::get<Column<T>>(columns), std::get<BatchOut<T>>(outs)), ...);
  }

  Function function_;
};

}  // namespace dini
