#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/terminal.h"

namespace dini::cli {
namespace {

/// The newest format of documents, and so far the only one. A newer one has its step from the one before in `upgrade`.
constexpr int newest_format = 1;

struct Options {
  std::vector<std::string> files;
  Console console;
};

int upgrade(const Options& options, const std::string& path, const Engine& engine) {
  const auto source = read_source(path);
  if (!source) return options.console.fail(source.problems(), exit_code_for(source.problems(), Stage::checking));
  const auto document = parse_source(*source, engine.limits());
  const Problems wrong = document ? Problems{} : document.problems();
  if (!wrong.empty()) return options.console.fail(wrong, exit_code_for(wrong, Stage::checking), &*source);
  // The engine reads the newest format only and says what is wrong with any other.
  const auto read = engine.interface(*engine.read(*document));
  if (!read) return options.console.fail(read.problems(), exit_invalid_graph, &*source);
  std::cout << printable(source->name) << ": format " << newest_format << " is the newest, nothing to do\n";
  return exit_ok;
}

int run(const Options& options, const EngineMaker& make_engine) {
  const std::unique_ptr<Engine> engine = make_engine({});
  int worst = exit_ok;
  for (const std::string& path : options.files) worst = std::max(worst, upgrade(options, path, *engine));
  return worst;
}

}  // namespace

void add_upgrade(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("upgrade", "Bring graph documents of older formats to the newest one");
  const auto options = std::make_shared<Options>();
  command->add_option("files", options->files, "The documents, or - for standard input")->required();
  options->console.add_options(*command);
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli
