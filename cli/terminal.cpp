#include "cli/terminal.h"

#include <cstdlib>
#include <iostream>
#include <unistd.h>

#include "cli/evaluation.h"
#include "cli/exit_codes.h"
#include "service/engine.h"

namespace dini::cli {
namespace {

/// The place in a graph, or the option that a problem is about.
std::string subject_of(const Json& problem, bool in_request) {
  const std::string node = problem.value("node", ""), port = problem.value("port", "");
  if (!node.empty()) return node + (port.empty() ? "" : "." + port);
  const std::string pointer = problem.value("pointer", "");
  constexpr std::string_view parameters = "/parameters/";
  if (in_request && pointer.starts_with(parameters)) return "--set " + pointer.substr(parameters.size());
  return pointer;
}

/// `graph.json:3:7: ` of what has a place in a file.
std::string place_text(const Json& problem) {
  if (!problem.contains("file")) return "";
  std::string text = problem.value("file", "");
  if (problem.contains("line")) {
    text += ":" + std::to_string(problem.value("line", 0)) + ":" + std::to_string(problem.value("column", 0));
  }
  return text + ": ";
}

std::string line_of(const Json& problem, bool in_request, const std::string& kind) {
  const std::string subject = subject_of(problem, in_request);
  return printable(place_text(problem)) + kind + ": " +
         printable((subject.empty() ? "" : subject + ": ") + problem.value("detail", "") + " [" +
                   problem.value("code", "") + "]");
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::string_view hexadecimal = "0123456789abcdef";
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // The controls U+0080 to U+009F hide behind the byte c2; some terminals obey them like escape sequences.
    const bool second_control = byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if (byte >= 0x20 && byte != 0x7f && !second_control) {
      result += text[i];
      continue;
    }
    const auto shown = second_control ? static_cast<unsigned char>(text[++i]) : byte;
    result += "\\x";
    result += hexadecimal[shown >> 4];
    result += hexadecimal[shown & 15];
  }
  return result;
}

std::string problem_line(const Problem& problem, const SourceText* source) {
  return line_of(problems_json({problem}, source).front(), problem.in_request, "error");
}

std::vector<std::string> warning_lines(const Json& report, const SourceText& source, const std::string& kind) {
  std::vector<std::string> lines;
  for (const Json& warning : report.value("warnings", Json::array())) {
    const Problem located{.node = warning.value("node", ""), .port = warning.value("port", "")};
    Json told = warning;
    told["file"] = source.name;
    if (const auto place = place_of(source, located)) {
      told["line"] = place->line;
      told["column"] = place->column;
    }
    lines.push_back(line_of(told, false, kind));
  }
  return lines;
}

void Console::add_options(CLI::App& command) {
  command.add_option("--color", color_, "auto (default: on a terminal, without NO_COLOR), always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}));
}

void Console::add_json_option(CLI::App& command, const std::string& description) {
  command.add_flag("--json", json_, description);
}

bool Console::colors(int descriptor) const {
  if (color_ != "auto") return color_ == "always";
  const char* unwanted = std::getenv("NO_COLOR");
  return (unwanted == nullptr || *unwanted == '\0') && ::isatty(descriptor) != 0;
}

bool Console::colors_errors() const { return colors(STDERR_FILENO); }
bool Console::colors_output() const { return colors(STDOUT_FILENO); }

void Console::problems(const Problems& problems, const SourceText* source) const {
  const std::string kind = colors_errors() ? "\x1b[1;31merror\x1b[0m" : "error";
  const Json list = problems_json(problems, source);
  for (std::size_t i = 0; i < problems.size(); ++i) {
    Json problem = list[i];
    // With several graphs even what is wrong with an option has to say for which of them.
    if (source != nullptr) problem["file"] = source->name;
    std::cerr << line_of(problem, problems[i].in_request, kind) << "\n";
  }
}

void Console::warnings(const Json& report, const SourceText& source) const {
  const std::string kind = colors_errors() ? "\x1b[1;33mwarning\x1b[0m" : "warning";
  for (const std::string& line : warning_lines(report, source, kind)) std::cerr << line << "\n";
}

int Console::fail(const Problems& told, int code, const SourceText* source) const {
  if (json_ && code != exit_usage) {
    std::cout << written({{"succeeded", false}, {"errors", problems_json(told, source)}});
  } else {
    problems(told, source);
  }
  return code;
}

int fail(const Problems& problems, int code, const SourceText* source) {
  return Console().fail(problems, code, source);
}

}  // namespace dini::cli
