#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "graph/file.h"
#include "graph/problem.h"

namespace dini::server {

/// The built web page, held in memory: no request ever reaches the file system, so no path can lead anywhere else.
class Page {
 public:
  struct File {
    SharedBytes bytes;
    SharedBytes gzip;  ///< the neighbor `name.gz`; null without one
    std::string type;
    std::string tag;
    bool immutable = false;  ///< the name carries a hash of the content
  };

  /// An empty page.
  Page() = default;

  /// Every regular file below a folder. Symbolic links are refused, since they may lead out of it; hidden files are
  /// left out.
  static Result<Page> load(const std::filesystem::path& folder);

  /// The file for a decoded URL path; "/" is index.html.
  const File* find(std::string_view path) const;

 private:
  std::map<std::string, File, std::less<>> files_;  ///< by URL path
};

/// The media type for a file name; application/octet-stream for names that are not known.
std::string_view media_type(std::string_view name);

/// True for names such as `main-5ZQ2W7KD.js`: they can be cached for ever.
bool carries_hash(std::string_view name);

}  // namespace dini::server
