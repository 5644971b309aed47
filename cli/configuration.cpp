#include "cli/configuration.h"

#include <cstdlib>
#include <toml++/toml.h>

#include "cli/documents.h"
#include "cli/problems.h"
#include "cli/setting.h"
#include "graph/nearest.h"
#include "service/limit_table.h"

namespace dini::cli {
namespace {

constexpr std::size_t most_configuration_bytes = std::size_t{1} << 20;

const char* named(SettingKind kind) {
  switch (kind) {
    case SettingKind::number:
      return "a whole number";
    case SettingKind::text:
      return "a text in quotes";
    case SettingKind::list:
      break;
  }
  return "a list of texts";
}

/// What a value of the file is as words of the command line; nothing when it is of the wrong kind.
std::optional<std::vector<std::string>> words_of(const toml::node& value, SettingKind kind) {
  if (kind == SettingKind::number) {
    if (!value.is_integer()) return std::nullopt;
    return std::vector{std::to_string(value.as_integer()->get())};
  }
  if (value.is_string()) return std::vector{value.as_string()->get()};
  const toml::array* list = value.as_array();
  if (kind != SettingKind::list || list == nullptr) return std::nullopt;
  std::vector<std::string> words;
  for (const toml::node& entry : *list) {
    if (!entry.is_string()) return std::nullopt;
    words.push_back(entry.as_string()->get());
  }
  return words;
}

/// Sets an option to other words. What is wrong with them; empty when nothing is.
std::string set(CLI::Option& option, const std::vector<std::string>& words) {
  option.clear();
  for (const std::string& word : words) option.add_result(word);
  try {
    if (!words.empty()) option.run_callback();
  } catch (const CLI::ParseError& error) {
    const std::string said = error.what(), flag = option.get_name() + ": ";
    return said.starts_with(flag) ? said.substr(flag.size()) : said;
  }
  return "";
}

/// Sets an option to what the file says, and back when something else has set it before.
std::string try_value(CLI::Option& option, const toml::node& value) {
  const SettingKind kind = kind_of(option);
  const auto words = words_of(value, kind);
  if (!words) return std::string("needs ") + named(kind);
  const std::vector<std::string> before = option.results();
  std::string wrong = set(option, *words);
  if (!before.empty()) set(option, before);
  return wrong;
}

/// Whether the environment set an option that is set.
bool is_from_environment(const CLI::Option& option) {
  const char* value = option.get_envname().empty() ? nullptr : std::getenv(option.get_envname().c_str());
  if (value == nullptr || option.count() == 0) return false;
  std::string given;
  for (const std::string& word : option.results()) given += (given.empty() ? "" : ",") + word;
  return given == value;
}

}  // namespace

Configuration::Configuration(CLI::App& command) : command_(command) {
  file_option_ = command.add_option("--config", file_,
                                    "A file in TOML with any of these settings, called as their flags are, with "
                                    "underscores. Flags and the environment win over it");
  command.add_flag("--print-config", print_, "Print all settings as such a file, and end");
}

void Configuration::name_variables() {
  for (CLI::Option* option : settings_of(command_)) {
    if (option->get_envname().empty()) option->envname(variable_of(name_of(*option)));
    if (kind_of(*option) == SettingKind::list) option->delimiter(',');
  }
}

Problems Configuration::read() {
  if (file_.empty()) return {};
  const Result<std::string> text = read_input(file_, most_configuration_bytes);
  if (!text) return text.problems();
  toml::table table;
  try {
    table = toml::parse(*text);
  } catch (const toml::parse_error& error) {
    return {usage_problem(file_ + ":" + std::to_string(error.source().begin.line) + ": " +
                          std::string(error.description()))};
  }
  std::map<std::string, CLI::Option*> settings;
  std::vector<std::string> names;
  for (CLI::Option* option : settings_of(command_)) {
    if (option == file_option_) continue;
    settings.emplace(name_of(*option), option);
    names.push_back(name_of(*option));
  }
  Problems problems;
  for (const auto& [key, value] : table) {
    const std::string name(key.str());
    const std::string place = file_ + ":" + std::to_string(key.source().begin.line) + ": ";
    const auto found = settings.find(name);
    if (found == settings.end()) {
      problems.push_back(usage_problem(place + "there is no setting '" + name + "'" + did_you_mean(name, names)));
      continue;
    }
    const bool was_set = found->second->count() > 0;
    const std::string wrong = try_value(*found->second, value);
    if (!wrong.empty()) problems.push_back(usage_problem(place + name + ": " + wrong));
    if (!was_set) from_file_.insert(found->second);
  }
  return problems;
}

std::string Configuration::text() const {
  std::string text = as_comment("Every setting of dini serve, to be read by dini serve --config FILE.");
  for (const CLI::Option* option : settings_of(command_)) {
    if (option == file_option_) continue;
    const std::string name = name_of(*option);
    const auto usual = usual_.find(option);
    std::string origin = "default";
    if (from_file_.contains(option)) {
      origin = "from " + file_;
    } else if (is_from_environment(*option)) {
      origin = "from " + option->get_envname();
    } else if (option->count() > 0) {
      origin = "from --" + option->get_lnames().front();
    }
    text += "\n" + as_comment(option->get_description() + ". " + option->get_envname());
    if (option->count() == 0 && usual == usual_.end()) {
      text += "# " + name + " is not set\n";
    } else if (hidden_.contains(option)) {
      text += "# " + name + " is set, and not shown; " + origin + "\n";
    } else {
      const std::vector<std::string> values = option->count() > 0 ? option->results() : std::vector{usual->second};
      text += name + " = " + written(values, kind_of(*option)) + "  # " + origin + "\n";
    }
  }
  return text;
}

}  // namespace dini::cli
