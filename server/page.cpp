#include "server/page.h"

#include <algorithm>
#include <array>

#include "server/files.h"
#include "server/text.h"

namespace dini::server {
namespace {

struct MediaType {
  std::string_view extension;
  std::string_view type;
};

constexpr std::array media_types = {
    MediaType{".html", "text/html; charset=utf-8"},
    MediaType{".js", "text/javascript; charset=utf-8"},
    MediaType{".mjs", "text/javascript; charset=utf-8"},
    MediaType{".css", "text/css; charset=utf-8"},
    MediaType{".json", "application/json"},
    MediaType{".map", "application/json"},
    MediaType{".wasm", "application/wasm"},
    MediaType{".svg", "image/svg+xml"},
    MediaType{".png", "image/png"},
    MediaType{".jpg", "image/jpeg"},
    MediaType{".webp", "image/webp"},
    MediaType{".ico", "image/x-icon"},
    MediaType{".woff2", "font/woff2"},
    MediaType{".glb", "model/gltf-binary"},
    MediaType{".gltf", "model/gltf+json"},
    MediaType{".txt", "text/plain; charset=utf-8"},
    MediaType{".md", "text/markdown; charset=utf-8"},
};

constexpr std::string_view gzip_extension = ".gz";

Problem cannot_serve(const std::filesystem::path& path, std::string_view why) {
  return {.code = "io", .detail = path.string() + ": " + std::string(why)};
}

}  // namespace

std::string_view media_type(std::string_view name) {
  const auto dot = name.rfind('.');
  const std::string_view extension = dot == std::string_view::npos ? std::string_view{} : name.substr(dot);
  const auto found = std::ranges::find(media_types, extension, &MediaType::extension);
  return found != media_types.end() ? found->type : "application/octet-stream";
}

bool carries_hash(std::string_view name) {
  const auto slash = name.rfind('/');
  if (slash != std::string_view::npos) name.remove_prefix(slash + 1);
  const auto dot = name.find('.');
  const auto dash = name.substr(0, dot).rfind('-');
  if (dash == std::string_view::npos) return false;
  const std::string_view hash = name.substr(0, dot).substr(dash + 1);
  const auto in_hash = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  return hash.size() >= 8 && std::ranges::all_of(hash, in_hash);
}

Result<Page> Page::load(const std::filesystem::path& folder) {
  Page page;
  std::error_code error;
  std::filesystem::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::recursive_directory_iterator(); entry.increment(error)) {
    const std::filesystem::path& path = entry->path();
    if (path.filename().string().starts_with('.')) {
      entry.disable_recursion_pending();
      continue;
    }
    if (entry->is_symlink(error)) return cannot_serve(path, "symbolic links are not served");
    if (!entry->is_regular_file(error)) continue;
    auto bytes = read_file(path);
    if (!bytes) return bytes.problems();
    const std::string url = "/" + path.lexically_relative(folder).generic_string();
    File& file = page.files_[url];
    file = {.bytes = share(*std::move(bytes)),
            .gzip = nullptr,
            .type = std::string(media_type(url)),
            .tag = {},
            .immutable = carries_hash(url)};
    file.tag = "\"" + content_hash(*file.bytes) + "\"";
  }
  if (error) return cannot_serve(folder, error.message());
  for (auto& [url, file] : page.files_) {
    const auto packed = page.files_.find(url + std::string(gzip_extension));
    if (packed != page.files_.end()) file.gzip = packed->second.bytes;
  }
  std::erase_if(page.files_, [](const auto& named) { return named.first.ends_with(gzip_extension); });
  if (page.find("/") == nullptr) return cannot_serve(folder, "there is no index.html");
  return page;
}

const Page::File* Page::find(std::string_view path) const {
  const auto found = files_.find(path == "/" ? std::string_view("/index.html") : path);
  return found != files_.end() ? &found->second : nullptr;
}

}  // namespace dini::server
