#include "cli/given_graph.h"

#include "cli/documents.h"
#include "cli/exit_codes.h"

namespace dini::cli {

void GraphArguments::add_options(CLI::App& command) {
  command.add_option("graph", path_, "The graph document, or - for standard input")->required();
  command.add_option("--set", settings_, "A parameter as name=value; may be repeated")->allow_extra_args(false);
  assets_.add_option(command);
  console_.add_options(command);
}

Expected<GivenGraph, int> GraphArguments::load(
    const EngineMaker& make_engine,
    const std::function<void(const Problems& problems, const SourceText* source)>& told) const {
  const auto failed = [&](const Problems& problems, const SourceText* source = nullptr) {
    if (told) told(problems, source);
    return console_.fail(problems, exit_code_for(problems, Stage::checking), source);
  };
  const Limits limits;
  Result<Json> parameters = read_settings(settings_, limits);
  if (!parameters) return failed(parameters.problems());
  if (const Problems wrong = read_twice(path_, assets_.paths()); !wrong.empty()) return failed(wrong);
  Result<SourceText> source = read_source(path_);
  if (!source) return failed(source.problems());
  Result<Json> document = parse_source(*source, limits);
  if (!document) return failed(document.problems(), &*source);
  std::unique_ptr<Engine> engine = make_engine(limits);
  if (const Problems wrong = assets_.give_to(*engine, {&*document}, Cancel()); !wrong.empty()) return failed(wrong);
  SharedGraph graph = engine->read(*document);
  return GivenGraph{*std::move(source), *std::move(document), *std::move(parameters), std::move(engine),
                    std::move(graph)};
}

}  // namespace dini::cli
