#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/documents.h"
#include "cli/evaluation.h"
#include "cli/exit_codes.h"
#include "cli/output_files.h"
#include "cli/problems.h"
#include "cli/terminal.h"
#include "golden/any_model.h"
#include "golden/compare.h"
#include "service/graph_difference.h"

namespace dini::cli {
namespace {

struct DiffOptions {
  std::string before, after;
  double tolerance = 1e-6;
  Console console;
};

/// What a difference looks like for people: a line each.
class Lines {
 public:
  /// Names are written after `kind`, and of nodes after the name of the group that they are in.
  void add(const Json& differences, const std::string& kind) {
    for (const Json& name : differences["removed"]) line("- " + kind + name.get<std::string>());
    for (const Json& name : differences["added"]) line("+ " + kind + name.get<std::string>());
    for (const auto& [name, changes] : differences["changed"].items()) add_changes(kind + name, changes);
  }

 private:
  static void line(const std::string& text) { std::cout << printable(text) << "\n"; }

  static std::string side(const Json& change, const char* name) {
    return change.contains(name) ? dump(change[name]) : "default";
  }

  void add_changes(const std::string& name, const Json& changes) {
    for (const auto& [member, change] : changes.items()) {
      // Inputs may be called anything, "nodes" as well.
      const bool is_member = change.contains("from") || change.contains("to");
      if (member == "inputs" && !is_member) {
        add_changes(name, change);
      } else if (member == "nodes" && !is_member) {
        add(change, name + "/");
      } else {
        line("~ " + name + "." + member + ": " + side(change, "from") + " -> " + side(change, "to"));
      }
    }
  }
};

bool is_empty(const Json& differences) {
  return differences["added"].empty() && differences["removed"].empty() && differences["changed"].empty();
}

int compare_graphs(const DiffOptions& options, const Json& before, const Json& after) {
  const Json difference = graph_difference(before, after);
  const bool has_groups = difference.contains("groups");
  const bool same = is_empty(difference["nodes"]) && is_empty(difference["parameters"]) &&
                    (!has_groups || is_empty(difference["groups"]));
  if (options.console.json()) {
    std::cout << written(difference);
  } else {
    Lines lines;
    lines.add(difference["parameters"], "parameter ");
    if (has_groups) lines.add(difference["groups"], "group ");
    lines.add(difference["nodes"], "");
  }
  return same ? exit_ok : exit_check_failed;
}

Result<AnyModel> read_model(const SourceText& source) {
  Expected<AnyModel, std::string> read = read_any_model(source.text);
  if (!read) return Problem{.code = "invalid-asset", .detail = source.name + ": " + read.error()};
  return *std::move(read);
}

/// What of a model is not compared.
Json warnings_of(const AnyModel& model) {
  Json warnings = Json::array();
  for (const std::string& sentence : model.left_out) warnings.push_back({{"code", "left-out"}, {"detail", sentence}});
  return warnings;
}

int compare_models(const DiffOptions& options, const SourceText& before, const SourceText& after) {
  const Result<AnyModel> first = read_model(before), second = read_model(after);
  for (const Result<AnyModel>* model : {&first, &second}) {
    if (!*model) return options.console.fail(model->problems(), exit_invalid_graph);
  }
  const Comparison comparison = compare(first->model.facts, second->model, options.tolerance);
  const bool changed = comparison.verdict == Comparison::Verdict::changed;
  if (options.console.json()) {
    const bool same_bytes = comparison.verdict == Comparison::Verdict::same;
    std::cout << Json{{"same_bytes", same_bytes},
                      {"same_shape", !changed},
                      {"differences", comparison.differences},
                      {"left_out", {{"before", first->left_out}, {"after", second->left_out}}}}
                     .dump(2)
              << "\n";
  } else {
    options.console.warnings({{"warnings", warnings_of(*first)}}, before);
    options.console.warnings({{"warnings", warnings_of(*second)}}, after);
    for (const std::string& difference : comparison.differences) std::cout << difference << "\n";
  }
  return changed ? exit_check_failed : exit_ok;
}

int run(const DiffOptions& options) {
  const auto failed = [&](const Problems& problems, const SourceText* source = nullptr) {
    return options.console.fail(problems, exit_code_for(problems, Stage::checking), source);
  };
  if (const Problems wrong = read_twice(options.before, {options.after}); !wrong.empty()) return failed(wrong);
  const auto before = read_source(options.before);
  if (!before) return failed(before.problems());
  const auto after = read_source(options.after);
  if (!after) return failed(after.problems());
  const auto is_model = [](const SourceText& source) { return source.text.starts_with("glTF"); };
  if (is_model(*before) != is_model(*after)) {
    return failed({usage_problem("two graphs are compared, or two models (GLB), not one with the other")});
  }
  if (is_model(*before)) return compare_models(options, *before, *after);
  std::vector<Json> documents;
  for (const SourceText* source : {&*before, &*after}) {
    Result<Json> document = parse_source(*source, Limits());
    if (!document) return failed(document.problems(), source);
    if (!looks_like_graph(*document)) {
      return failed({{.code = "required-member-missing", .detail = "this is no graph document"}}, source);
    }
    documents.push_back(*std::move(document));
  }
  return compare_graphs(options, documents[0], documents[1]);
}

}  // namespace

void add_diff(CLI::App& program, Command& chosen) {
  auto* command = program.add_subcommand(
      "diff", "Compare two graphs by what they mean, or two models by their shape; ends with 1 when they differ");
  command->footer(
      "dini diff before.json after.json\n"
      "dini diff before.glb after.glb --tolerance 1e-4");
  const auto options = std::make_shared<DiffOptions>();
  command->add_option("before", options->before, "A graph document or a GLB, or - for standard input")->required();
  command->add_option("after", options->after, "Another one of the same kind")->required();
  command
      ->add_option("--tolerance", options->tolerance,
                   "How far models may be from each other, as a share of the largest extent, beside what files round "
                   "positions by (default: 1e-6)")
      ->check(CLI::Range(0.0, 1.0));
  options->console.add_json_option(*command, "Answer as JSON");
  options->console.add_options(*command);
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace dini::cli
