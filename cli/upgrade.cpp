#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/document_results.h"
#include "cli/documents.h"
#include "cli/exit_codes.h"
#include "cli/terminal.h"

namespace dini::cli {
namespace {

/// The newest format of documents. It only adds to the one before, so that documents of both are read as they are.
constexpr int newest_format = 2;

struct UpgradeOptions {
  std::vector<std::string> files;
  Console console;
};

void upgrade(const std::string& path, const Engine& engine, bool says, DocumentResults& results) {
  const auto source = read_source(path);
  if (!source) {
    return results.add_failure(path, source.problems(), exit_code_for(source.problems(), Stage::checking));
  }
  const auto document = parse_source(*source, engine.limits());
  if (!document) {
    const int code = exit_code_for(document.problems(), Stage::checking);
    return results.add_failure(source->name, document.problems(), code, &*source);
  }
  // The engine says what is wrong with a format that it does not read.
  const auto read = engine.interface(*engine.read(*document));
  if (!read) return results.add_failure(source->name, read.problems(), exit_invalid_graph, &*source);
  const int format = document->value("format", newest_format);
  if (says) {
    std::cout << printable(source->name) << ": format " << format
              << (format == newest_format ? " is the newest" : " is read as it is") << ", nothing to do\n";
  }
  results.add(source->name, {{"format", format}, {"changed", false}});
}

int run(const UpgradeOptions& options, const EngineMaker& make_engine) {
  if (const Problems wrong = read_twice("", options.files); !wrong.empty()) {
    return options.console.fail(wrong, exit_usage);
  }
  const std::unique_ptr<Engine> engine = make_engine({});
  DocumentResults results(options.console);
  for (const std::string& path : options.files) upgrade(path, *engine, !options.console.json(), results);
  return results.finish();
}

}  // namespace

void add_upgrade(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("upgrade", "Bring graph documents of older formats to the newest one");
  const auto options = std::make_shared<UpgradeOptions>();
  command->add_option("files", options->files, "The documents, or - for standard input")->required();
  options->console.add_json_option(*command, "Answer as JSON: the format of each file, or what is wrong with it");
  options->console.add_options(*command);
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli
