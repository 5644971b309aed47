#include "service/requests/results.h"
#include "service/requests/schema.h"

namespace dini {

Json job_schemas() {
  using namespace schema;
  const Json variants = object({{"total", whole("How many there are.")},
                                {"done", whole("How many have a line.")},
                                {"failed", whole("How many of these failed.")}},
                               "Of a sweep.");
  const Json best = object({{"parameters", map_of(number(""), "By name.")},
                            {"objective", number("What is to be small.")},
                            {"missing", number("How far targets are from being kept; there beside `minimize`."), true}},
                           "Of a fit that runs: what it has found so far.");
  return {
      {"Job", object({{"id", text("Names the job.")},
                      {"kind", word({"evaluate", "sweep", "fit"}, "What it does.")},
                      {"state", word({"queued", "running", "succeeded", "failed", "canceling", "canceled", "expired"},
                                     "Where it is.")},
                      {"progress", number("From 0 to 1; never goes back while the job runs.")},
                      {"created", text("When it was asked for: RFC 3339, in UTC.")},
                      {"started", text("When it began last."), true},
                      {"finished", text("When it ended."), true},
                      {"variants", variants, true},
                      {"best", best, true},
                      {"errors", list(reference("ProblemEntry"), "Why it failed.")},
                      {"address", text("Where to ask how it fares.")},
                      {"events", text("Where to follow it.")},
                      {"result", text("Where what came of it is, once it has succeeded."), true}},
                     "Long work.")}};
}

}  // namespace dini
