#include <iostream>
#include <memory>

#include "cli/command_markdown.h"
#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/manual_page.h"
#include "cli/output_files.h"
#include "cli/terminal.h"
#include "server/description_markdown.h"
#include "server/files.h"
#include "server/openapi.h"
#include "service/version.h"

namespace dini::cli {
namespace {

struct DescribeOptions {
  std::string page;
  bool commands = false;
  bool manual = false;
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

int run(const DescribeOptions& options, const CLI::App& program) {
  if (options.commands) {
    std::cout << commands_markdown(program);
    return exit_ok;
  }
  if (options.manual) {
    std::cout << manual_page(program);
    return exit_ok;
  }
  if (!options.page.empty()) return update(options.page);
  std::cout << server::openapi_document(server::routes(), engine_version).dump(2) << "\n";
  return exit_ok;
}

}  // namespace

void add_describe(CLI::App& program, Command& chosen) {
  auto* command =
      program.add_subcommand("describe", "Print the HTTP interface as OpenAPI, or the pages about the command line");
  const auto options = std::make_shared<DescribeOptions>();
  auto* page = command->add_option("--update", options->page,
                                   "Instead, write the generated parts of this page of documentation anew");
  auto* commands =
      command->add_flag("--commands", options->commands, "Instead, print the page about the command line, docs/cli.md")
          ->excludes(page);
  command->add_flag("--manual", options->manual, "Instead, print the manual, for man")
      ->excludes(page)
      ->excludes(commands);
  command->callback([options, &chosen, &program] { chosen = [options, &program] { return run(*options, program); }; });
}

}  // namespace dini::cli
