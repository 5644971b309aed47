#include "cli/eval_targets.h"

#include <filesystem>

#include "cli/exit_codes.h"
#include "cli/output_names.h"
#include "cli/problems.h"

namespace dini::cli {
namespace {

/// ".glb (glb), .gltf (gltf)"
std::string list_of(std::span<const FileFormat> formats) {
  std::string text;
  for (const FileFormat& format : formats) {
    text += (text.empty() ? "" : ", ") + format.extension + " (" + format.name + ")";
  }
  return text;
}

/// The format that is asked for, else the one that the name of the file ends with; the usual one for a device or pipe.
Result<const FileFormat*> format_of(const EvalWishes& wishes, const std::string& path,
                                    std::span<const FileFormat> formats) {
  const std::string ending = path != "-" ? std::filesystem::path(path).extension().string() : "";
  const FileFormat* format = &formats.front();
  if (!wishes.format.empty()) {
    format = format_named(formats, wishes.format);
    if (format == nullptr) {
      return usage_problem("--format " + wishes.format + " is none that can be written; there is " + list_of(formats));
    }
  } else if (!ending.empty()) {
    format = format_of_extension(formats, ending);
    if (format == nullptr) {
      return usage_problem("-o " + path + ": " + ending +
                           " is no format that can be written (--format says another); there is " + list_of(formats));
    }
  }
  if (format != &formats.front() && wishes.previews) {
    return usage_problem("--preview is written as GLB only; there is " + list_of(formats));
  }
  return format;
}

EvalGraph read_graph(const std::string& path, const Limits& limits) {
  EvalGraph graph{.path = path};
  const auto fail_with = [&](const Problems& problems) {
    graph.problems = problems;
    graph.code = exit_code_for(problems, Stage::checking);
    return graph;
  };
  Result<SourceText> source = read_source(path);
  if (!source) return fail_with(source.problems());
  graph.source = *std::move(source);
  Result<Json> document = parse_source(*graph.source, limits);
  if (!document) return fail_with(document.problems());
  graph.document = *std::move(document);
  return graph;
}

/// The outputs of a graph that are to be written, and the pattern of each. A graph without any, or that is wrong, gets
/// one target all the same, which then says what is wrong.
std::vector<std::pair<std::string, std::string>> wanted_of(const Engine& engine, const EvalGraph& graph,
                                                           const OutputNames& names, const EvalWishes& wishes) {
  if (!names.named.empty()) return {names.named.begin(), names.named.end()};
  if (!wishes.output.empty() || wishes.previews || !names.tells_outputs()) return {{wishes.output, names.pattern}};
  std::vector<std::pair<std::string, std::string>> wanted;
  const auto interface = graph.document ? engine.interface(*engine.read(*graph.document)) : Problems();
  if (interface) {
    for (const Json& output : interface->value("outputs", Json::array())) wanted.emplace_back(output, names.pattern);
  }
  if (wanted.empty()) wanted.emplace_back("", names.pattern);
  return wanted;
}

Problems misfits(const OutputNames& names, const EvalWishes& wishes) {
  if (!names.named.empty() && (!wishes.output.empty() || wishes.previews)) {
    return {usage_problem("-o OUTPUT=FILE says which outputs are made; --output and --preview do not go with it")};
  }
  if (wishes.graphs.size() < 2) return {};
  std::vector<std::string> patterns;
  if (!names.pattern.empty()) patterns.push_back(names.pattern);
  for (const auto& [output, pattern] : names.named) patterns.push_back(pattern);
  for (const std::string& pattern : patterns) {
    if (cli::names(pattern, "graph")) continue;
    return {usage_problem("-o " + pattern +
                          " would be written by each of the graphs; {graph} in it stands for their names")};
  }
  return {};
}

}  // namespace

Result<std::vector<EvalGraph>> eval_graphs(const Engine& engine, const EvalWishes& wishes) {
  const auto names = read_output_names(wishes.outputs, {"graph", "output"});
  if (!names) return names.problems();
  if (Problems wrong = misfits(*names, wishes); !wrong.empty()) return wrong;
  std::vector<EvalGraph> graphs;
  for (const std::string& path : wishes.graphs) {
    EvalGraph graph = read_graph(path, engine.limits());
    for (const auto& [output, pattern] : wanted_of(engine, graph, *names, wishes)) {
      EvalTarget target{.output = output};
      if (!pattern.empty()) {
        const std::string shown = !output.empty() ? output : wishes.previews ? "preview" : "out";
        target.path = filled(pattern, {{"graph", graph_name(path)}, {"output", shown}});
      }
      const auto format = format_of(wishes, target.path.value_or(""), engine.formats());
      if (!format) return format.problems();
      target.format = *format;
      graph.targets.push_back(std::move(target));
      if (!graph.problems.empty()) break;  // they are told once
    }
    graphs.push_back(std::move(graph));
  }
  return graphs;
}

}  // namespace dini::cli
