#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/document_results.h"
#include "cli/documents.h"
#include "cli/exit_codes.h"
#include "cli/layout.h"
#include "cli/output_files.h"
#include "cli/problems.h"
#include "cli/terminal.h"

namespace dini::cli {
namespace {

struct FmtOptions {
  std::vector<std::string> files;
  bool check = false;
  Console console;
};

/// What is laid out must be a graph document as far as that can be told without knowing its nodes: wrong ones are laid
/// out as well, other files never.
Problems other_kind(const Json& document) {
  if (document.is_object() && document.contains("format") && document.contains("nodes")) return {};
  return {{.code = "required-member-missing",
           .detail = "this is no graph document: those are objects with the members format and nodes",
           .pointer = ""}};
}

void format(const FmtOptions& options, const std::string& path, DocumentResults& results) {
  const auto source = read_source(path);
  if (!source) {
    return results.add_failure(path, source.problems(), exit_code_for(source.problems(), Stage::checking));
  }
  const auto document = parse_source(*source, Limits());
  const Problems wrong = document ? other_kind(*document) : document.problems();
  if (!wrong.empty()) {
    return results.add_failure(source->name, wrong, exit_code_for(wrong, Stage::checking), &*source);
  }
  const std::string laid_out = canonical_layout(source->text);
  const bool changes = laid_out != source->text;
  if (options.check) {
    if (changes && !options.console.json()) std::cout << printable(source->name) << " would be laid out anew\n";
  } else if (changes || path == "-") {
    if (const Problems unwritten = write_output(path, laid_out); !unwritten.empty()) {
      return results.add_failure(source->name, unwritten, exit_io);
    }
  }
  results.add(source->name, {{"changed", changes}}, options.check && changes ? exit_check_failed : exit_ok);
}

int run(const FmtOptions& options) {
  if (const Problems wrong = read_twice("", options.files); !wrong.empty()) {
    return options.console.fail(wrong, exit_usage);
  }
  const bool writes_document = !options.check && std::ranges::find(options.files, "-") != options.files.end();
  if (writes_document && options.console.json()) {
    return options.console.fail(
        {usage_problem("standard output takes the document of - or the answer of --json, not both")}, exit_usage);
  }
  DocumentResults results(options.console);
  for (const std::string& path : options.files) format(options, path, results);
  return results.finish();
}

}  // namespace

void add_fmt(CLI::App& program, Command& chosen) {
  auto* command = program.add_subcommand(
      "fmt", "Lay graph documents out as those of the examples are: one node a line; nothing else changes");
  command->footer(
      "dini fmt parts/*.json\n"
      "dini fmt --check parts/*.json");
  const auto options = std::make_shared<FmtOptions>();
  command
      ->add_option("files", options->files,
                   "The documents to rewrite; - reads standard input and writes standard output")
      ->required();
  command->add_flag("--check", options->check,
                    "Only name the files that would change, and end with 1 if there are any");
  options->console.add_json_option(*command, "Answer as JSON: which files change, and what is wrong with others");
  options->console.add_options(*command);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace dini::cli
