#include "cli/program.h"

#include <algorithm>
#include <exception>
#include <fcntl.h>
#include <iostream>
#include <new>
#include <unistd.h>

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/terminal.h"
#include "graph/nearest.h"
#include "service/version.h"

namespace dini::cli {
namespace {

std::string line(const char* code, const std::string& detail) {
  return problem_line({.code = code, .detail = detail}) + "\n";
}

/// One line for what is wrong with the words themselves; the library gives two.
std::string usage_line(const CLI::App* program, const CLI::Error& error) {
  const auto given = program->get_subcommands();
  const std::string command = given.empty() ? "" : " " + given.front()->get_name();
  return line("usage", error.what() + ("; see dini" + command) + " --help");
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

int run(int count, const char* const* words, const EngineMaker& make_engine) {
  CLI::App program("Dini evaluates graphs of geometry nodes into Draco-compressed glTF.", "dini");
  program.require_subcommand(1);
  program.set_version_flag("--version", engine_version);
  Command chosen;
  add_serve(program, chosen, make_engine);
  add_worker(program, chosen, make_engine);
  add_queue(program, chosen);
  add_eval(program, chosen, make_engine);
  add_sweep(program, chosen, make_engine);
  add_fit(program, chosen, make_engine);
  add_test(program, chosen, make_engine);
  add_validate(program, chosen, make_engine);
  add_inspect(program, chosen, make_engine);
  add_diff(program, chosen);
  add_explain(program, chosen, make_engine);
  add_hash(program, chosen, make_engine);
  add_fmt(program, chosen);
  add_upgrade(program, chosen, make_engine);
  add_merge(program, chosen, make_engine);
  add_nodes(program, chosen, make_engine);
  add_store(program, chosen);
  add_describe(program, chosen);
  add_completion(program, chosen);
  program.failure_message(usage_line);
  if (const std::string wrong = wrong_command(program, count, words); !wrong.empty()) {
    std::cerr << line("usage", wrong + "; see dini --help");
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
    std::cerr << line("io", "standard output cannot be written");
    return exit_io;
  }
  return code;
}

/// A socket or a file that took the number of a closed standard stream would be written to as if it were that stream.
void open_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) < 0) ::open("/dev/null", O_RDWR);
  }
}

}  // namespace

int run_program(int count, const char* const* words, const EngineMaker& make_engine) {
  open_standard_streams();
  try {
    return run(count, words, make_engine);
  } catch (const std::bad_alloc&) {
    std::cerr << "error: there is not enough memory for this [out-of-memory]\n";
    return exit_limit;
  } catch (const std::exception& error) {
    std::cerr << line("internal", error.what());
  } catch (...) {
    std::cerr << line("internal", "something unexpected went wrong");
  }
  return exit_our_bug;
}

}  // namespace dini::cli
