#pragma once

// A stand-in for dini::Engine, so that the tests of the server and of the command line decide what evaluation does. A
// program that compiles toy_engine.cpp in gets its members instead of the real ones.
//
// Its graphs are {"format": 1, "nodes": {"out": {"inputs": {...}}}} with these inputs:
//   milliseconds  how long an evaluation takes, while it looks at its Cancel
//   bytes         how large the model is
//   problem       the code of the problem that the evaluation ends with
//   invalid       the code of the problem that checking finds
//   throws        true: an exception escapes, as if by a bug of ours
// Its files are refused when they begin with "broken" (invalid-asset) or "large" (limit-exceeded).

#include <atomic>
#include <cstddef>

namespace dini::toy {

struct Counters {
  std::atomic<std::size_t> started = 0;   ///< evaluations begun
  std::atomic<std::size_t> finished = 0;  ///< and ended, one way or another
  std::atomic<std::size_t> canceled = 0;  ///< of these, stopped by their Cancel
};

Counters& counters();

}  // namespace dini::toy
