#include <exception>
#include <iostream>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/terminal.h"

int main(int count, char** words) {
  using namespace dini::cli;
  try {
    std::ios::sync_with_stdio(false);
    CLI::App program("Dini evaluates graphs of geometry nodes into Draco-compressed glTF.", "dini");
    program.require_subcommand(1);
    program.set_version_flag("--version", DINI_VERSION);
    Command chosen;
    add_serve(program, chosen);
    add_eval(program, chosen);
    add_validate(program, chosen);
    add_inspect(program, chosen);
    add_nodes(program, chosen);
    try {
      program.parse(count, words);
    } catch (const CLI::ParseError& error) {
      return program.exit(error) == 0 ? exit_ok : exit_usage;
    }
    return chosen();
  } catch (const std::exception& error) {
    std::cerr << "error[internal]: " << printable(error.what()) << "\n";
  } catch (...) {
    std::cerr << "error[internal]: something unexpected went wrong\n";
  }
  return exit_our_bug;
}
