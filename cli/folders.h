#pragma once

#include <filesystem>
#include <string>

namespace dini::cli {

/// The folder given, else the first that exists of those beside the program: in a build tree, or installed. Empty when
/// there is none.
std::filesystem::path find_folder(const std::string& given, const char* in_build_tree, const char* installed);

/// `find_folder` for the example graphs.
std::filesystem::path find_examples(const std::string& given);

/// Where graphs are kept: the folder given, else the one for dini among the user's data. Empty when the user has no
/// home.
std::filesystem::path data_folder(const std::string& given);

}  // namespace dini::cli
