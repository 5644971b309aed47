#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace dini::cli {

/// What may be written for an option in a file.
enum class SettingKind { number, text, list };

/// The options of a command that are settings: those with a value and a long name.
std::vector<CLI::Option*> settings_of(CLI::App& command);

SettingKind kind_of(const CLI::Option& option);

/// snake_case: `body_bytes` for --body-bytes.
std::string name_of(const CLI::Option& option);

/// The values as they are written in a file.
std::string written(const std::vector<std::string>& values, SettingKind kind);

/// The words of a sentence in lines of at most 100 bytes, each a comment.
std::string as_comment(const std::string& sentence);

}  // namespace dini::cli
