#include "cli/manual_page.h"

#include "cli/command_tree.h"
#include "service/version.h"

namespace dini::cli {
namespace {

constexpr const char* endings = R"(.SH EXIT STATUS
0 done; 1 a check failed or what was compared differs; 2 wrong words; 3 a wrong graph; 4 the evaluation failed;
5 a limit or the deadline; 6 a file; 70 a bug of Dini.
.SH FILES
Without
.B \-\-data
the server keeps graphs and jobs in
.IR $XDG_DATA_HOME/dini ,
which is usually
.IR ~/.local/share/dini .
)";

/// Text that troff shows as it is.
std::string plain(const std::string& text) {
  std::string shown;
  bool at_start = true;
  for (const char c : text) {
    // A line that begins with one of these would be a request.
    if (at_start && (c == '.' || c == '\'')) shown += "\\&";
    if (c == '\\') {
      shown += "\\e";
    } else if (c == '-') {
      shown += "\\-";
    } else {
      shown += c;
    }
    at_start = c == '\n';
  }
  return shown;
}

std::string item(const DescribedOption& option) {
  std::string names;
  for (const std::string& flag : option.flags) names += (names.empty() ? "" : ", ") + ("\\fB" + plain(flag) + "\\fR");
  if (!option.value.empty()) names += (names.empty() ? "" : " ") + ("\\fI" + plain(option.value) + "\\fR");
  const std::string variable = option.variable.empty() ? "" : " (" + option.variable + ")";
  return ".TP\n" + names + "\n" + plain(option.doc + variable) + ".\n";
}

std::string manual_section(const DescribedCommand& command) {
  std::string text = ".SS \"dini " + plain(command.name) + "\"\n" + plain(command.doc) + ".\n";
  for (const DescribedOption& option : command.options) text += item(option);
  if (!command.examples.empty()) text += ".PP\n.EX\n" + plain(command.examples) + "\n.EE\n";
  for (const DescribedCommand& deeper : command.commands) text += manual_section(deeper);
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& program) {
  std::string page = ".TH DINI 1 \"\" \"Dini " + std::string(engine_version) + "\"\n.SH NAME\ndini \\- " +
                     "evaluate graphs of geometry nodes into models\n.SH SYNOPSIS\n.B dini\n.I COMMAND\n" +
                     ".RI [ OPTION ...]\n.SH DESCRIPTION\n" + plain(program.get_description()) + "\n.SH COMMANDS\n";
  for (const DescribedCommand& command : described_commands(program)) page += manual_section(command);
  return page + endings;
}

}  // namespace dini::cli
