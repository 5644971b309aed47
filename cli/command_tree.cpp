#include "cli/command_tree.h"

#include <algorithm>

namespace dini::cli {
namespace {

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// What an option takes, in a word: that of its name where it has one word.
std::string value_of(const CLI::Option& option) {
  if (option.get_positional()) return upper(option.get_name(true));
  if (option.get_expected_max() == 0) return "";
  const std::string name = option.get_lnames().empty() ? "" : option.get_lnames().front();
  return name.empty() || name.find('-') != std::string::npos ? "VALUE" : upper(name);
}

/// The library tells the words of an option behind its type: "TEXT:{draft,final}".
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const auto begin = type.find('{'), end = type.rfind('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

DescribedOption described(const CLI::Option& option) {
  DescribedOption described{.value = value_of(option),
                            .doc = option.get_description(),
                            .choices = choices_of(option),
                            .variable = option.get_envname(),
                            .is_required = option.get_required()};
  if (option.get_positional()) return described;
  for (const std::string& flag : option.get_snames()) described.flags.push_back("-" + flag);
  for (const std::string& flag : option.get_lnames()) described.flags.push_back("--" + flag);
  return described;
}

DescribedCommand described(const CLI::App& command, const std::string& before) {
  DescribedCommand found{before + command.get_name(), command.get_description(), command.get_footer(), {}, {}};
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_name() != "--help") found.options.push_back(described(*option));
  }
  for (const CLI::App* deeper : command.get_subcommands({})) {
    found.commands.push_back(described(*deeper, found.name + " "));
  }
  return found;
}

}  // namespace

std::vector<DescribedCommand> described_commands(const CLI::App& program) {
  std::vector<DescribedCommand> commands;
  for (const CLI::App* command : program.get_subcommands({})) commands.push_back(described(*command, ""));
  return commands;
}

}  // namespace dini::cli
