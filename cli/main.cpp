#include <exception>
#include <iostream>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/terminal.h"

namespace dini::cli {
namespace {

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
  try {
    program.parse(count, words);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? exit_ok : exit_usage;
  }
  return chosen();
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
