#include "cli/output_names.h"

#include <algorithm>
#include <filesystem>

#include "cli/problems.h"
#include "graph/nearest.h"
#include "service/graph.h"

namespace dini::cli {
namespace {

/// Calls `found` with the name in each pair of braces and where they begin and end.
template <class Found>
void each_name(const std::string& pattern, Found found) {
  for (std::size_t open = pattern.find('{'); open != std::string::npos; open = pattern.find('{', open + 1)) {
    const std::size_t close = pattern.find('}', open);
    if (close == std::string::npos) return;
    found(pattern.substr(open + 1, close - open - 1), open, close + 1);
    open = close;
  }
}

Problems faults_in(const std::string& pattern, const std::vector<std::string>& known) {
  if (pattern.empty()) return {usage_problem("-o needs a file, or - for standard output")};
  Problems faults;
  each_name(pattern, [&](const std::string& name, std::size_t, std::size_t) {
    if (std::ranges::find(known, name) != known.end()) return;
    std::string list;
    for (const std::string& each : known) list += (list.empty() ? "{" : ", {") + each + "}";
    faults.push_back(usage_problem("-o " + pattern + ": {" + name + "} means nothing" + did_you_mean(name, known) +
                                   "; there is " + list));
  });
  return faults;
}

}  // namespace

bool names(const std::string& pattern, const std::string& name) {
  return pattern.find("{" + name + "}") != std::string::npos;
}

bool OutputNames::tells_outputs() const { return names(pattern, "output"); }

Result<OutputNames> read_output_names(const std::vector<std::string>& words, const std::vector<std::string>& known) {
  OutputNames read;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    const bool is_named = equals != std::string::npos && is_node_id(word.substr(0, equals));
    const std::string pattern = is_named ? word.substr(equals + 1) : word;
    if (Problems faults = faults_in(pattern, known); !faults.empty()) return faults;
    if (is_named) {
      if (!read.named.emplace(word.substr(0, equals), pattern).second) {
        return usage_problem("-o gives the output '" + word.substr(0, equals) + "' twice");
      }
    } else if (!read.pattern.empty()) {
      return usage_problem("-o is given twice; several outputs take NAME=FILE each, or one pattern with {output}");
    } else {
      read.pattern = pattern;
    }
  }
  if (!read.pattern.empty() && !read.named.empty()) {
    return usage_problem("-o takes one pattern, or NAME=FILE for each output, not both");
  }
  return read;
}

std::string filled(const std::string& pattern, const std::map<std::string, std::string>& values) {
  std::string text;
  std::size_t after = 0;
  each_name(pattern, [&](const std::string& name, std::size_t begin, std::size_t end) {
    const auto value = values.find(name);
    if (value == values.end()) return;
    std::string shown = value->second;
    // The id of an output within groups is a path of ids, and no path of folders.
    if (name == "output") std::replace(shown.begin(), shown.end(), '/', '-');
    text += pattern.substr(after, begin - after) + shown;
    after = end;
  });
  return text + pattern.substr(after);
}

std::string graph_name(const std::string& path) {
  return path == "-" ? "graph" : std::filesystem::path(path).stem().string();
}

}  // namespace dini::cli
