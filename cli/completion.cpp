// What shells complete: commands, their options, and the words of options that have only a few; files elsewhere.

#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/command_tree.h"
#include "cli/commands.h"
#include "cli/exit_codes.h"

namespace dini::cli {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// The name of a command without those that it belongs to.
std::string last_word(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

std::vector<std::string> names_of(const std::vector<DescribedCommand>& commands) {
  std::vector<std::string> names;
  for (const DescribedCommand& command : commands) names.push_back(last_word(command.name));
  return names;
}

/// Every option of a command and of its deeper ones, once.
std::vector<DescribedOption> all_options(const DescribedCommand& command) {
  std::vector<DescribedOption> options = command.options;
  for (const DescribedCommand& deeper : command.commands) {
    for (const DescribedOption& option : deeper.options) {
      const auto known = [&](const DescribedOption& other) { return other.flags == option.flags; };
      if (std::ranges::none_of(options, known)) options.push_back(option);
    }
  }
  std::erase_if(options, [](const DescribedOption& option) { return option.flags.empty(); });
  return options;
}

std::string bash(const std::vector<DescribedCommand>& commands) {
  std::string cases, values;
  for (const DescribedCommand& command : commands) {
    std::vector<std::string> flags = {"--help"};
    for (const DescribedOption& option : all_options(command)) {
      flags.insert(flags.end(), option.flags.begin(), option.flags.end());
      for (const std::string& flag : option.flags) {
        if (!option.choices.empty()) {
          values += "    '" + command.name + " " + flag + "') words='" + joined(option.choices) + "' ;;\n";
        }
      }
    }
    cases += "    " + command.name + ") options='" + joined(flags) + "' commands='" +
             joined(names_of(command.commands)) + "' ;;\n";
  }
  return R"(# Completion of dini for bash: `dini completion bash`.
_dini() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} options='' commands='' words=''
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W ')" +
         joined(names_of(commands)) + R"( --help --version' -- "$current")
    return
  fi
  case ${COMP_WORDS[1]} in
)" + cases +
         R"(  esac
  case "${COMP_WORDS[1]} $previous" in
)" + values +
         R"(  esac
  if [[ -z $words && $current == -* ]]; then words=$options; fi
  if [[ -z $words && $COMP_CWORD -eq 2 ]]; then words=$commands; fi
  if [[ -n $words ]]; then mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current"); fi
}
complete -o default -F _dini dini
)";
}

/// Text between single quotes of zsh and fish.
std::string quoted(const std::string& text, const char* quote) {
  std::string shown = "'";
  for (const char c : text) shown += c == '\'' ? std::string(quote) : std::string(1, c);
  return shown + "'";
}

std::string zsh(const std::vector<DescribedCommand>& commands) {
  constexpr const char* quote = "'\\''";
  const auto entry = [&](const std::string& name, const std::string& doc) {
    std::string plain;
    for (const char c : name) plain += c == ':' ? "\\:" : std::string(1, c);
    return "    " + quoted(plain + ":" + doc, quote) + "\n";
  };
  std::string names, cases;
  for (const DescribedCommand& command : commands) {
    names += entry(command.name, command.doc);
    std::string options, deeper;
    for (const DescribedOption& option : all_options(command)) {
      for (const std::string& flag : option.flags) options += "  " + entry(flag, option.doc);
    }
    for (const DescribedCommand& each : command.commands) deeper += "  " + entry(last_word(each.name), each.doc);
    cases += "    " + command.name + ")\n      options=(\n" + options + "      )\n      deeper=(\n" + deeper +
             "      ) ;;\n";
  }
  return R"(#compdef dini
# Completion of dini for zsh: `dini completion zsh`.
_dini() {
  local -a commands options deeper
  commands=(
)" + names +
         R"(  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  case $words[2] in
)" + cases +
         R"(  esac
  if [[ $PREFIX == -* ]]; then
    _describe option options
  elif ((CURRENT == 3 && $#deeper > 0)); then
    _describe command deeper
  else
    _files
  fi
}
_dini "$@"
)";
}

std::string fish(const std::vector<DescribedCommand>& commands) {
  constexpr const char* quote = "\\'";
  std::string text = "# Completion of dini for fish: `dini completion fish`.\n";
  for (const DescribedCommand& command : commands) {
    text +=
        "complete -c dini -n __fish_use_subcommand -f -a " + command.name + " -d " + quoted(command.doc, quote) + "\n";
    const std::string seen = "complete -c dini -n '__fish_seen_subcommand_from " + command.name + "'";
    for (const DescribedCommand& deeper : command.commands) {
      text += seen + " -f -a " + last_word(deeper.name) + " -d " + quoted(deeper.doc, quote) + "\n";
    }
    for (const DescribedOption& option : all_options(command)) {
      text += seen;
      for (const std::string& flag : option.flags) {
        text += flag.starts_with("--") ? " -l " + flag.substr(2) : " -s " + flag.substr(1);
      }
      if (!option.value.empty())
        text += option.choices.empty() ? " -r" : " -x -a " + quoted(joined(option.choices), quote);
      text += " -d " + quoted(option.doc, quote) + "\n";
    }
  }
  return text;
}

int run(const std::string& shell, const CLI::App& program) {
  const std::vector<DescribedCommand> commands = described_commands(program);
  std::cout << (shell == "bash" ? bash(commands) : shell == "zsh" ? zsh(commands) : fish(commands));
  return exit_ok;
}

}  // namespace

void add_completion(CLI::App& program, Command& chosen) {
  auto* command = program.add_subcommand("completion", "Print what a shell needs to complete commands and options");
  const auto shell = std::make_shared<std::string>();
  command->add_option("shell", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->footer("dini completion bash >~/.local/share/bash-completion/completions/dini");
  command->callback([shell, &chosen, &program] { chosen = [shell, &program] { return run(*shell, program); }; });
}

}  // namespace dini::cli
