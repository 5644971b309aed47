#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace dini::cli {

/// The manual of the program, as `man` reads it (man(7)).
std::string manual_page(const CLI::App& program);

}  // namespace dini::cli
