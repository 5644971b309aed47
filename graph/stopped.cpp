#include "graph/stopped.h"

namespace dini {

Problem stopped_problem(StopReason reason) {
  switch (reason) {
    case StopReason::superseded:
      return {"superseded", "a newer request with the same Supersede-Key took this one's place"};
    case StopReason::client_gone:
      return {"client-gone", "the client closed the connection"};
    case StopReason::canceled:
      return {"canceled", "the work was canceled"};
    case StopReason::shutting_down:
      return {"shutting-down", "the server is shutting down"};
    case StopReason::none:
    case StopReason::deadline:
      break;
  }
  return {"deadline", "the work was not done at its deadline"};
}

Problem out_of_memory() { return {"out-of-memory", "there is not enough memory for this now"}; }

}  // namespace dini
