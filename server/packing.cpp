#include "server/packing.h"

#include <algorithm>
#include <array>
#include <new>
#include <zlib.h>

#include "server/negotiation.h"
#include "server/text.h"

namespace dini::server {
namespace {

/// Smaller ones fit into a packet as they are.
constexpr std::size_t least_bytes = 1024;
/// Larger ones would take too long.
constexpr std::size_t most_bytes = 64 * 1024 * 1024;
/// A good half of what the best effort saves, in a fifth of its time.
constexpr int effort = 4;
constexpr int window_with_gzip_header = 15 + 16;
constexpr int usual_memory = 8;

constexpr std::array<std::string_view, 6> text_types = {
    "application/json", "application/problem+json", "application/schema+json", "text/html", "text/css", "text/plain"};

bool is_text(std::string_view type) {
  const std::string_view bare = trim(type.substr(0, type.find(';')));
  return std::ranges::find(text_types, bare) != text_types.end();
}

bool is_encoded(const Reply& reply) {
  return std::ranges::any_of(reply.headers, [](const auto& header) { return header.first == "Content-Encoding"; });
}

std::string joined(const std::vector<SharedBytes>& pieces) {
  std::string bytes;
  for (const SharedBytes& piece : pieces) bytes += *piece;
  return bytes;
}

/// The bytes as a gzip file; null when there is no memory for one.
SharedBytes gzip(std::string_view bytes) noexcept try {
  z_stream stream{};
  if (::deflateInit2(&stream, effort, Z_DEFLATED, window_with_gzip_header, usual_memory, Z_DEFAULT_STRATEGY) != Z_OK) {
    return nullptr;
  }
  struct End {
    z_stream& stream;
    ~End() { ::deflateEnd(&stream); }
  } const end{stream};
  std::string file(::deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(file.data());
  stream.avail_out = static_cast<uInt>(file.size());
  if (::deflate(&stream, Z_FINISH) != Z_STREAM_END) return nullptr;
  file.resize(stream.total_out);
  file.shrink_to_fit();
  return share(std::move(file));
} catch (const std::bad_alloc&) {
  return nullptr;
}

/// Says that the answer depends on what its client takes.
void add_vary(Reply& reply) {
  constexpr std::string_view header = "Accept-Encoding";
  const auto vary =
      std::ranges::find(reply.headers, "Vary", [](const auto& each) { return std::string_view(each.first); });
  if (vary == reply.headers.end()) {
    reply.headers.emplace_back("Vary", header);
  } else if (vary->second.find(header) == std::string::npos) {
    vary->second.append(", ").append(header);
  }
}

}  // namespace

Reply packed(Reply reply, const Exchange& exchange) {
  if (!is_text(reply.type) || reply.stream != nullptr || reply.status == 206) return reply;
  if (reply.size() < least_bytes || reply.size() > most_bytes || is_encoded(reply)) return reply;
  add_vary(reply);
  if (!exchange.accepts_gzip) return reply;
  SharedBytes file = reply.body.size() == 1 ? gzip(*reply.body.front()) : gzip(joined(reply.body));
  if (file == nullptr || file->size() >= reply.size()) return reply;
  reply.body = {std::move(file)};
  reply.headers.emplace_back("Content-Encoding", "gzip");
  return reply;
}

}  // namespace dini::server
