#include "cli/command_markdown.h"

#include <algorithm>

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
`pointer` (RFC 6901) into that file. What is wrong with an option has no file. The codes are those of [http.md](http.md).

## What is written

A file appears complete or not at all. Only files of the same kind are replaced: a model by its ending, a report by its content; never a
graph, an asset that is read, or anything else. Reports are written however a command ends, and those of an earlier run are taken away
first.
)";

/// Text in a cell of a table.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '<') result += '\\';
    result += c;
  }
  return result;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// What an option takes, in a word: that of its name where it has one word.
std::string value_of(const CLI::Option& option) {
  const std::string name = option.get_lnames().empty() ? "" : option.get_lnames().front();
  return name.empty() || name.find('-') != std::string::npos ? "VALUE" : upper(name);
}

/// `-o, --out` with what it takes.
std::string name_of(const CLI::Option& option) {
  if (option.get_positional()) return "`" + upper(option.get_name(true)) + "`";
  std::string name;
  for (const std::string& flag : option.get_snames()) name += (name.empty() ? "-" : ", -") + flag;
  for (const std::string& flag : option.get_lnames()) name += (name.empty() ? "--" : ", --") + flag;
  const bool is_flag = option.get_expected_max() == 0;
  return "`" + name + (is_flag ? "" : " " + value_of(option)) + "`";
}

std::string row(const CLI::Option& option) {
  std::string text = option.get_description();
  if (option.get_positional() && option.get_required()) text += " (required)";
  if (!option.get_envname().empty()) text += " (`" + option.get_envname() + "`)";
  return "| " + name_of(option) + " | " + cell(text) + " |\n";
}

std::string options_of(const CLI::App& command) {
  std::string rows;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_name() != "--help") rows += row(*option);
  }
  return rows.empty() ? "" : "\n| option | |\n|---|---|\n" + rows;
}

/// Deeper commands follow the one that they belong to, as `dini store list`.
std::string section(const CLI::App& command, const std::string& before) {
  const std::string name = before + " " + command.get_name();
  std::string text = "\n## " + name + "\n\n" + command.get_description() + ".\n" + options_of(command);
  if (!command.get_footer().empty()) text += "\n```sh\n" + command.get_footer() + "\n```\n";
  for (const CLI::App* deeper : command.get_subcommands({})) text += section(*deeper, name);
  return text;
}

}  // namespace

std::string commands_markdown(const CLI::App& program) {
  std::string page = head;
  for (const CLI::App* command : program.get_subcommands({})) page += section(*command, program.get_name());
  return page;
}

}  // namespace dini::cli
