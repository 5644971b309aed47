// The real program, with one format more.

#include "cli/program.h"
#include "nodes/formats.h"
#include "tests/formats/counts_format.h"

int main(int count, char** words) {
  return dini::cli::run_program(count, words, [](const dini::Limits& limits) {
    std::vector<dini::FileFormat> formats(dini::all_formats().begin(), dini::all_formats().end());
    formats.push_back(dini::support::counts_format());
    return dini::make_engine(limits, std::move(formats));
  });
}
