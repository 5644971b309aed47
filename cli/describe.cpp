#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/output_files.h"
#include "cli/terminal.h"
#include "server/description_markdown.h"
#include "server/files.h"
#include "server/openapi.h"
#include "service/version.h"

namespace dini::cli {
namespace {

struct Options {
  std::string page;
};

/// Writes the generated parts of a page of documentation anew.
int update(const std::string& path) {
  const auto page = server::read_file(path);
  if (!page) return fail(page.problems(), exit_io);
  const auto updated = server::with_generated_parts(*page);
  if (!updated) return fail(updated.problems(), exit_usage);
  const Problems wrong = write_output(path, *updated);
  return wrong.empty() ? exit_ok : fail(wrong, exit_io);
}

int run(const Options& options) {
  if (!options.page.empty()) return update(options.page);
  std::cout << server::openapi_document(server::routes(), engine_version).dump(2) << "\n";
  return exit_ok;
}

}  // namespace

void add_describe(CLI::App& program, Command& chosen) {
  auto* command = program.add_subcommand("describe", "Print the HTTP interface as OpenAPI");
  const auto options = std::make_shared<Options>();
  command->add_option("--update", options->page,
                      "Instead, write the generated parts of this page of documentation anew");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace dini::cli
