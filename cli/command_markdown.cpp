#include "cli/command_markdown.h"

#include "cli/command_tree.h"

namespace dini::cli {
namespace {

constexpr const char* head = R"(# The command line

`dini describe --commands` writes this page; [ci.md](ci.md) shows how pipelines use the commands.

## Exit codes

| code | meaning |
|---|---|
| 0 | done |
| 1 | a check of the graph failed, a model is not that of its golden result, or what was compared differs |
| 2 | the words of the call are wrong |
| 3 | the graph, its parameters or its cases are wrong |
| 4 | the evaluation failed |
| 5 | a limit or the deadline |
| 6 | a file cannot be read or written |
| 70 | a bug of Dini |

Where one call does several things, one that fails does not stop the others, and the exit code is the largest of all.

## Problems

A problem is one line on standard error, `file:line:column: error: node.port: what is wrong [code]`, as far as these are known.
Lines and columns count from 1, columns count characters. With `--json` problems are JSON instead, with `file`, `line`, `column` and a
`pointer` (RFC 6901) into that file. What is wrong with an option has no file, and what is wrong with the words of a call (exit code 2) is always
a line. The codes are those of [http.md](http.md).

## What is written

A file appears complete or not at all. Only files of the same kind are replaced: a model by its ending, a report by its content; never a
graph, an asset that is read, or anything else. Reports are written however a command ends, and those of an earlier run are taken away
first.
)";

/// Text in a cell of a table.
std::string table_cell(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '<') result += '\\';
    result += c;
  }
  return result;
}

/// `-o, --out` with what it takes.
std::string name_of(const DescribedOption& option) {
  std::string name;
  for (const std::string& flag : option.flags) name += (name.empty() ? "" : ", ") + flag;
  if (!option.value.empty()) name += (name.empty() ? "" : " ") + option.value;
  return "`" + name + "`";
}

std::string row(const DescribedOption& option) {
  std::string text = option.doc;
  if (option.flags.empty() && option.is_required) text += " (required)";
  if (!option.variable.empty()) text += " (`" + option.variable + "`)";
  return "| " + name_of(option) + " | " + table_cell(text) + " |\n";
}

/// Deeper commands follow the one that they belong to, as `dini store list`.
std::string command_section(const DescribedCommand& command) {
  std::string text = "\n## dini " + command.name + "\n\n" + command.doc + ".\n";
  if (!command.options.empty()) text += "\n| option | |\n|---|---|\n";
  for (const DescribedOption& option : command.options) text += row(option);
  if (!command.examples.empty()) text += "\n```sh\n" + command.examples + "\n```\n";
  for (const DescribedCommand& deeper : command.commands) text += command_section(deeper);
  return text;
}

}  // namespace

std::string commands_markdown(const CLI::App& program) {
  std::string page = head;
  for (const DescribedCommand& command : described_commands(program)) page += command_section(command);
  return page;
}

}  // namespace dini::cli
