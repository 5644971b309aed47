#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/documents.h"
#include "cli/evaluation.h"
#include "cli/exit_codes.h"
#include "cli/layout.h"
#include "cli/output_files.h"
#include "cli/problems.h"
#include "cli/terminal.h"
#include "service/graph_merge.h"

namespace dini::cli {
namespace {

struct MergeOptions {
  std::string base, ours, theirs;
  std::optional<std::string> out;
  Console console;
};

/// A document with the order of its members.
struct Side {
  SourceText source;
  OrderedJson document;
};

/// Reads strictly, as all documents are read.
Expected<Side, int> read_side(const MergeOptions& options, const std::string& path, const Limits& limits) {
  const auto failed = [&](const Problems& problems, const SourceText* source) {
    return options.console.fail(problems, exit_code_for(problems, Stage::checking), source);
  };
  auto source = read_source(path);
  if (!source) return failed(source.problems(), nullptr);
  const auto document = parse_source(*source, limits);
  if (!document) return failed(document.problems(), &*source);
  if (!looks_like_graph(*document)) {
    return failed({{.code = "required-member-missing", .detail = "this is no graph document"}}, &*source);
  }
  OrderedJson ordered = OrderedJson::parse(source->text);
  return Side{*std::move(source), std::move(ordered)};
}

/// What each side did alone can be wrong together: a link to a node that the other side took away, or a cycle.
Problems broken_links(const Engine& engine, const Json& merged) {
  const auto verdict = engine.validate(*engine.read(merged), Json::object(), Cancel(), Sent::request);
  Problems problems = verdict ? problems_of_request(verdict->value("errors", Json::array())) : verdict.problems();
  std::erase_if(problems, [](const Problem& problem) {
    return problem.code != "dangling-link" && problem.code != "graph-has-cycle";
  });
  return problems;
}

int run(const MergeOptions& options, const EngineMaker& make_engine) {
  const std::string out = options.out.value_or(options.ours);
  if (const Problems wrong = read_twice(options.base, {options.ours, options.theirs}); !wrong.empty()) {
    return options.console.fail(wrong, exit_usage);
  }
  if (out == "-" && options.console.json()) {
    return options.console.fail(
        {usage_problem("standard output takes the merged document or the answer of --json, not both")}, exit_usage);
  }
  const std::unique_ptr<Engine> engine = make_engine({});
  const auto base = read_side(options, options.base, engine->limits());
  if (!base) return base.error();
  const auto ours = read_side(options, options.ours, engine->limits());
  if (!ours) return ours.error();
  const auto theirs = read_side(options, options.theirs, engine->limits());
  if (!theirs) return theirs.error();
  const GraphMerge merge = merge_graphs(base->document, ours->document, theirs->document);
  Problems problems = merge.conflicts;
  const SourceText merged{options.ours, canonical_layout(merge.merged.dump())};
  if (problems.empty()) {
    const auto document = parse_source(merged, engine->limits());
    problems = document ? broken_links(*engine, *document) : document.problems();
  }
  // Their places are those in our side: the merged document is written nowhere.
  if (!problems.empty()) return options.console.fail(problems, exit_check_failed, &ours->source);
  if (const Problems wrong = write_output(out, merged.text); !wrong.empty()) {
    return options.console.fail(wrong, exit_io);
  }
  if (options.console.json()) std::cout << written({{"succeeded", true}, {"errors", Json::array()}});
  return exit_ok;
}

}  // namespace

void add_merge(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand(
      "merge",
      "Merge the changes of two sides to one graph document, as a merge driver of git; ends with 1 and changes nothing "
      "where both sides changed the same thing");
  command->footer("dini merge base.json ours.json theirs.json -o merged.json");
  const auto options = std::make_shared<MergeOptions>();
  command->add_option("base", options->base, "The document that both sides began with")->required();
  command->add_option("ours", options->ours, "Our side, which the merged document replaces")->required();
  command->add_option("theirs", options->theirs, "The other side")->required();
  command->add_option("-o,--out", options->out, "Where the merged document goes instead, or - for standard output");
  options->console.add_json_option(*command, "Answer as JSON: whether it merged, or what is in the way");
  options->console.add_options(*command);
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli
