#include <algorithm>
#include <exception>
#include <iostream>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/terminal.h"
#include "graph/nearest.h"

namespace dini::cli {
namespace {

/// One line for what is wrong with the words themselves; the library gives two.
std::string usage_line(const CLI::App* program, const CLI::Error& error) {
  const auto given = program->get_subcommands();
  const std::string command = given.empty() ? "" : " " + given.front()->get_name();
  return "error[usage]: " + printable(error.what()) + "; see dini" + command + " --help\n";
}

/// What is wrong with the first word when it should be a command and is none; empty for all others.
std::string wrong_command(const CLI::App& program, int count, const char* const* words) {
  if (count < 2) return "a command is needed";
  const std::string word = words[1];
  if (word.starts_with('-')) return "";
  std::vector<std::string> commands;
  for (const CLI::App* command : program.get_subcommands({})) commands.push_back(command->get_name());
  if (std::find(commands.begin(), commands.end(), word) != commands.end()) return "";
  return "there is no command '" + word + "'" + did_you_mean(word, commands);
}

int run(int count, const char* const* words) {
  CLI::App program("Dini evaluates graphs of geometry nodes into Draco-compressed glTF.", "dini");
  program.require_subcommand(1);
  program.set_version_flag("--version", DINI_VERSION);
  Command chosen;
  add_serve(program, chosen);
  add_eval(program, chosen);
  add_validate(program, chosen);
  add_inspect(program, chosen);
  add_nodes(program, chosen);
  program.failure_message(usage_line);
  if (const std::string wrong = wrong_command(program, count, words); !wrong.empty()) {
    std::cerr << "error[usage]: " << printable(wrong) << "; see dini --help\n";
    return exit_usage;
  }
  try {
    program.parse(count, words);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? exit_ok : exit_usage;
  }
  const int code = chosen();
  // What could not be written may be all that was asked for.
  if (code == exit_ok && !std::cout.flush()) {
    std::cerr << "error[io]: standard output cannot be written\n";
    return exit_io;
  }
  return code;
}

}  // namespace
}  // namespace dini::cli

int main(int count, char** words) {
  try {
    return dini::cli::run(count, words);
  } catch (const std::exception& error) {
    std::cerr << "error[internal]: " << dini::cli::printable(error.what()) << "\n";
  } catch (...) {
    std::cerr << "error[internal]: something unexpected went wrong\n";
  }
  return dini::cli::exit_our_bug;
}
