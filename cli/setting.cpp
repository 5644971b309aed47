#include "cli/setting.h"

#include <algorithm>
#include <sstream>

#include "service/engine.h"

namespace dini::cli {

std::vector<CLI::Option*> settings_of(CLI::App& command) {
  return command.get_options(
      [](const CLI::Option* option) { return option->get_expected_max() > 0 && !option->get_lnames().empty(); });
}

SettingKind kind_of(const CLI::Option& option) {
  if (option.get_expected_max() > 1) return SettingKind::list;
  const std::string type = option.get_type_name();
  return type.starts_with("UINT") || type.starts_with("INT") ? SettingKind::number : SettingKind::text;
}

std::string name_of(const CLI::Option& option) {
  std::string name = option.get_lnames().front();
  std::ranges::replace(name, '-', '_');
  return name;
}

std::string written(const std::vector<std::string>& values, SettingKind kind) {
  // A text of JSON is a text of TOML, but for DEL, which JSON leaves as it is.
  const auto quoted = [](const std::string& text) {
    std::string result = dump(Json(text));
    for (auto at = result.find('\x7f'); at != std::string::npos; at = result.find('\x7f', at)) {
      result.replace(at, 1, "\\u007f");
    }
    return result;
  };
  if (kind != SettingKind::list) {
    const std::string value = values.empty() ? "" : values.front();
    return kind == SettingKind::number ? value : quoted(value);
  }
  std::string list;
  for (const std::string& value : values) list += (list.empty() ? "" : ", ") + quoted(value);
  return "[" + list + "]";
}

std::string as_comment(const std::string& sentence) {
  constexpr std::size_t width = 100;
  std::istringstream words(sentence);
  std::string text, line = "#", word;
  while (words >> word) {
    if (line.size() + 1 + word.size() > width) text += std::exchange(line, "#") + "\n";
    line += " " + word;
  }
  return text + line + "\n";
}

}  // namespace dini::cli
