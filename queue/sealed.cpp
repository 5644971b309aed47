#include "queue/sealed.h"

#include "graph/digest.h"

namespace dini::queue {
namespace {

/// All that stands before the bytes. What is sealed is right when it begins with the head that its bytes have.
std::string head_of(std::string_view media_type, std::string_view engine, std::string_view bytes) {
  std::string head = "dini 1 ";
  head.append(engine).append(" ").append(media_type).append(" ");
  head += std::to_string(bytes.size()) + " " + to_hex(sha256(bytes)) + "\n";
  return head;
}

}  // namespace

std::string sealed(std::string_view media_type, std::string_view engine, std::string_view bytes) {
  return head_of(media_type, engine, bytes).append(bytes);
}

std::optional<std::string_view> unsealed(std::string_view value, std::string_view media_type, std::string_view engine) {
  const auto end = value.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view bytes = value.substr(end + 1);
  if (value.substr(0, end + 1) != head_of(media_type, engine, bytes)) return std::nullopt;
  return bytes;
}

}  // namespace dini::queue
