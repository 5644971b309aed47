#include "service/problem_codes.h"

#include <algorithm>
#include <array>

namespace dini {
namespace {

using enum ProblemKind;

constexpr std::array kinds = {request, graph, file, service, warning, program};

constexpr std::array codes = {
    ProblemCode{"not-json", request, 400,
                "The body is no strict JSON: a syntax error, a key twice, NUL, NaN, or too deeply nested."},
    ProblemCode{"bad-request", request, 400, "The request is not well-formed HTTP; the connection is closed."},
    ProblemCode{"unauthorized", request, 401,
                "This server has a token, and `Authorization: Bearer <token>` is missing or wrong."},
    ProblemCode{"foreign-origin", request, 403,
                "A page of another origin sent the request, or lets a browser load it."},
    ProblemCode{"not-found", request, 404, "There is nothing at this address."},
    ProblemCode{"method-not-allowed", request, 405,
                "The address does not take this method; `Allow` lists those it does."},
    ProblemCode{"not-acceptable", request, 406, "None of the media types in `Accept` is available here."},
    ProblemCode{"request-timeout", request, 408, "The head or the body of the request arrived too slowly."},
    ProblemCode{"superseded", request, 409, "A newer request with the same `Supersede-Key` took this one's place."},
    ProblemCode{"job-unfinished", request, 409, "The job has not ended, so there is nothing yet that came of it."},
    ProblemCode{"job-expired", request, 410,
                "What came of the job was kept for `job_result_milliseconds` and is gone."},
    ProblemCode{"length-required", request, 411, "A body needs `Content-Length`, or comes in chunks."},
    ProblemCode{"precondition-failed", request, 412,
                "What is kept is not what `If-Match` or `If-None-Match` says; `ETag` tells what it is."},
    ProblemCode{"body-too-large", request, 413, "The body is longer than the address accepts."},
    ProblemCode{"uri-too-long", request, 414, "The request line is longer than `line_bytes`."},
    ProblemCode{"unsupported-media-type", request, 415,
                "The body has a media type that the address does not take, or it is compressed."},
    ProblemCode{"range-not-satisfiable", request, 416,
                "The part that `Range` names begins beyond the end of the file."},
    ProblemCode{"expectation-failed", request, 417, "Only `Expect: 100-continue` is understood."},
    ProblemCode{"misdirected-request", request, 421,
                "The `Host` is not one of this server's names; `--allow-host` adds some."},
    ProblemCode{"idempotency-key-reused", request, 422, "A job for another request has that `Idempotency-Key`."},
    ProblemCode{"precondition-required", request, 428,
                "A graph is written with `If-None-Match: *` where there is none, and else with `If-Match`."},
    ProblemCode{"too-many-wrong-tokens", request, 429,
                "More wrong tokens than `wrong_tokens` a minute came from this address; the right one is still taken."},
    ProblemCode{"headers-too-large", request, 431,
                "The headers are larger or more than `head_bytes`, `line_bytes` or `header_count`."},
    ProblemCode{"client-gone", request, 499, "The client left before its answer; only the log has this."},
    ProblemCode{"http-version", request, 505, "Only HTTP/1.1 and HTTP/1.0 are spoken."},

    ProblemCode{"required-input-missing", graph, 422, "An input or a member that must be given is missing."},
    ProblemCode{"required-member-missing", graph, 422, "A member of the document that must be given is missing."},
    ProblemCode{"unknown-member", graph, 422, "A member is not known; the nearest known name is told."},
    ProblemCode{"unsupported-format", graph, 422, "The document has a format that this version does not read."},
    ProblemCode{"invalid-id", graph, 422, "A name is not a letter followed by up to 63 letters, digits, `_` or `-`."},
    ProblemCode{"unknown-node-type", graph, 422, "There is no node type, or no group, of that name."},
    ProblemCode{"recursive-group", graph, 422, "A group contains itself, at once or through another one."},
    ProblemCode{"unknown-port", graph, 422, "The node has no input or output of that name."},
    ProblemCode{"unknown-parameter", graph, 422, "The graph has no parameter of that name."},
    ProblemCode{"unknown-node", graph, 422, "The request names a node that the graph has not."},
    ProblemCode{"unknown-output", graph, 422,
                "The request names an output that the graph has not, or none of several."},
    ProblemCode{"unknown-graph", graph, 422, "The request names a graph that is not kept here."},
    ProblemCode{"unknown-asset", graph, 422, "The graph names a mesh file that this server has not been given."},
    ProblemCode{"dangling-link", graph, 422, "A link begins at a node or output that does not exist."},
    ProblemCode{"graph-has-cycle", graph, 422, "Links run in a circle."},
    ProblemCode{"type-mismatch", graph, 422, "A value or a wire has another type than its place takes."},
    ProblemCode{"axis-mismatch", graph, 422, "Axes of one name differ in size or closure, or an axis is missing."},
    ProblemCode{"out-of-range", graph, 422, "A number is outside of what its place accepts."},
    ProblemCode{"not-in-choices", graph, 422, "A word is none of the choices."},
    ProblemCode{"invalid-formula", graph, 422, "A formula cannot be read."},
    ProblemCode{"invalid-links", graph, 422, "A text that lists links between points cannot be read."},
    ProblemCode{"limit-exceeded", graph, 422, "A document, a file or a predicted result is larger than a limit."},
    ProblemCode{"non-finite", graph, 422, "A number is not finite, or became so while it was computed."},
    ProblemCode{"degenerate", graph, 422, "A value has no meaning for the node: a zero vector as an axis, say."},
    ProblemCode{"at-infinity", graph, 422, "Points of the result lie at infinity, and the node was told to fail then."},
    ProblemCode{"check-failed", graph, 422, "A `check` of the graph does not hold, or cannot run."},
    ProblemCode{"poisoned-input", graph, 422,
                "A variant of a sweep ended every worker that computed it, and is given to no other for an hour."},
    ProblemCode{"nothing-to-export", graph, 422, "An `export` node was given nothing that can be drawn."},
    ProblemCode{"encode-failed", graph, 422, "A mesh could not be written."},
    ProblemCode{"more-problems", graph, 422, "Stands last when more than 100 problems were found, with their number."},

    ProblemCode{"invalid-asset", file, 422, "The file is no OBJ, PLY, STL or GLB that can be read."},

    ProblemCode{"busy", service, 503, "All places are taken just now; try again after `Retry-After` seconds."},
    ProblemCode{"queue-failed", service, 503,
                "The queue before the workers cannot be reached, or no worker is there; try again later."},
    ProblemCode{"out-of-memory", service, 503, "There is not enough memory for this now."},
    ProblemCode{"storage-full", service, 507, "There is no room to keep what was sent; what is kept can be read."},
    ProblemCode{"storage-failed", service, 503, "What is kept cannot be read or written just now."},
    ProblemCode{"shutting-down", service, 503, "The server is about to stop."},
    ProblemCode{"canceled", service, 409, "The work was canceled."},
    ProblemCode{"deadline", service, 504, "The work was not done at its deadline."},
    ProblemCode{"internal", service, 500, "Something went wrong here; the log has it under the id of the request."},

    ProblemCode{"left-out", warning, 0, "A part of a file has no place in its mesh and was left out."},
    ProblemCode{"empty", warning, 0, "A part of a model has nothing to draw and was left out."},
    ProblemCode{"capped", warning, 0, "A solid reached the border of the box, and was closed there."},
    ProblemCode{"self-contact", warning, 0, "A wall meets itself; what would fit is told."},
    ProblemCode{"coarse", warning, 0, "There are so many circles that each has fewer segments than usual."},
    ProblemCode{"imprecise", warning, 0, "Texture coordinates reach so far that they are rounded visibly."},
    ProblemCode{"triangle-budget", warning, 0, "A draft has more triangles than asked for and cannot be thinner."},

    ProblemCode{"usage", program, 0, "The words of the command line are not understood."},
    ProblemCode{"io", program, 0, "A file cannot be read or written."},
    ProblemCode{"golden-changed", program, 0, "A model is not that of its golden result."},
    ProblemCode{"golden-missing", program, 0, "There is no golden result to compare a model with."},
    ProblemCode{"golden-stale", program, 0, "A golden result is of a case that there is no more."},
    ProblemCode{"bad-golden", program, 0, "A file is no golden result that this version reads."},
    ProblemCode{"bad-cases", program, 0, "A file of cases cannot be read, or is not as it has to be."},
    ProblemCode{"unexpected-success", program, 0, "A case that must fail did not."},
    ProblemCode{"merge-conflict", program, 0, "Two sides changed the same thing of a graph, each in another way."},
    ProblemCode{"address", program, 0, "The server cannot listen at its address."},
    ProblemCode{"bad-example", program, 0, "An example or its mesh file is wrong, so the server does not start."},
};

}  // namespace

std::span<const ProblemCode> problem_codes() { return codes; }

const ProblemCode* find_problem_code(std::string_view code) {
  const auto found = std::ranges::find(codes, code, &ProblemCode::code);
  return found != codes.end() ? &*found : nullptr;
}

std::span<const ProblemKind> problem_kinds() { return kinds; }

std::string_view title_of(ProblemKind kind) {
  switch (kind) {
    case request:
      return "about requests";
    case graph:
      return "about graphs";
    case file:
      return "about files";
    case service:
      return "about the service";
    case warning:
      return "warnings";
    case program:
      break;
  }
  return "of the program";
}

}  // namespace dini
