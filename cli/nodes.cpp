#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/folders.h"
#include "server/files.h"
#include "service/document_schema.h"
#include "service/engine.h"
#include "service/markdown.h"

namespace dini::cli {
namespace {

struct NodesOptions {
  bool json = false;
  bool markdown = false;
  bool schema = false;
};

void print_list(const Json& catalogue) {
  for (const Json& node : catalogue.value("nodes", Json::array())) {
    std::string id = node.value("id", "");
    id.resize(std::max<std::size_t>(id.size(), 20), ' ');
    std::cout << id << " " << node.value("description", "") << "\n";
  }
}

/// The examples of single nodes; none when the program is run without the folder.
NodeExamples read_node_examples() {
  NodeExamples examples;
  std::error_code error;
  std::filesystem::directory_iterator entry(find_examples("") / "nodes", error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (entry->path().extension() != ".json") continue;
    const auto text = server::read_file(entry->path());
    if (!text) continue;
    auto graph = nlohmann::ordered_json::parse(*text, nullptr, false);
    if (!graph.is_discarded()) examples.emplace(entry->path().stem().string(), std::move(graph));
  }
  return examples;
}

int run(const NodesOptions& options, const EngineMaker& make_engine) {
  const std::unique_ptr<Engine> engine = make_engine({});
  if (options.json) {
    std::cout << engine->catalogue().dump(2) << "\n";
  } else if (options.schema) {
    std::cout << document_schema(engine->catalogue()).dump(2) << "\n";
  } else if (options.markdown) {
    std::cout << nodes_markdown(engine->catalogue(), read_node_examples());
  } else {
    print_list(engine->catalogue());
  }
  return exit_ok;
}

}  // namespace

void add_nodes(CLI::App& program, Command& chosen, const EngineMaker& make_engine) {
  auto* command = program.add_subcommand("nodes", "List the node types");
  const auto options = std::make_shared<NodesOptions>();
  auto* json = command->add_flag("--json", options->json, "The whole catalogue as JSON");
  auto* markdown = command->add_flag("--markdown", options->markdown, "The catalogue as a page to read");
  auto* schema = command->add_flag("--schema", options->schema, "The JSON Schema of graph documents");
  json->excludes(markdown)->excludes(schema);
  markdown->excludes(schema);
  command->callback(
      [options, &chosen, &make_engine] { chosen = [options, &make_engine] { return run(*options, make_engine); }; });
}

}  // namespace dini::cli
