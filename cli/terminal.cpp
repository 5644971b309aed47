#include "cli/terminal.h"

#include <iostream>

#include "service/engine.h"

namespace dini::cli {

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

std::string problem_line(const Json& problem) {
  const auto member = [&](const char* name) { return problem.value(name, std::string()); };
  std::string place = member("node");
  if (!place.empty() && !member("port").empty()) place += "." + member("port");
  if (place.empty()) place = member("pointer");
  return printable("error[" + member("code") + "]" + (place.empty() ? "" : " " + place) + ": " + member("detail"));
}

void print_problems(const Problems& problems) {
  for (const Json& problem : to_json(problems, Sent::document)) std::cerr << problem_line(problem) << "\n";
}

int fail(const Problems& problems, int code) {
  print_problems(problems);
  return code;
}

}  // namespace dini::cli
