#include "server/answer_writer.h"

#include <array>
#include <cstdio>
#include <ctime>

#include "server/responses.h"

namespace dini::server {
namespace {

/// Draco's decoder is WebAssembly in a worker made from a blob; without these two permissions the page hangs silently.
constexpr std::string_view content_security_policy =
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; style-src 'self'; "
    "img-src 'self' data: blob:; connect-src 'self'; object-src 'none'; base-uri 'none'; frame-ancestors ";

void add(std::string& text, std::string_view name, std::string_view value) {
  text.append(name).append(": ").append(value).append("\r\n");
}

void add_timings(std::string& text, const Reply& reply, const Exchange& exchange) {
  std::array<char, 64> number{};
  text += "Server-Timing: ";
  for (const auto& [name, milliseconds] : reply.notes.timings) {
    std::snprintf(number.data(), number.size(), ";dur=%.3f, ", milliseconds);
    text.append(name).append(number.data());
  }
  std::snprintf(number.data(), number.size(), "total;dur=%.3f\r\n", exchange.milliseconds());
  text += number.data();
}

void add_date(std::string& text) {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 64> date{};
  ::gmtime_r(&now, &parts);
  text.append("Date: ").append(date.data(),
                               std::strftime(date.data(), date.size(), "%a, %d %b %Y %H:%M:%S GMT\r\n", &parts));
}

/// Whose pages may read the answer (Fetch, 3.2).
void add_sharing(std::string& text, const Reply& reply, const Exchange& exchange) {
  if (exchange.differs_by_origin) add(text, "Vary", "Origin");
  const bool shared = !exchange.shared_with.empty();
  // A frame is asked for without an origin; the policy says who may have it.
  const bool framed = !reply.framed_by.empty();
  add(text, "Cross-Origin-Resource-Policy", shared || framed ? "cross-origin" : "same-origin");
  // Pages that are isolated from other origins show no frame that is not.
  if (framed) add(text, "Cross-Origin-Embedder-Policy", "require-corp");
  if (!shared) return;
  add(text, "Access-Control-Allow-Origin", exchange.shared_with);
  add(text, "Access-Control-Expose-Headers",
      "ETag, Location, Content-Location, Content-Disposition, Content-Range, Accept-Ranges, Allow, Retry-After, "
      "Server-Timing, X-Request-Id");
}

bool has_body(int status) { return status >= 200 && status != 204 && status != 304; }

}  // namespace

std::string answer_head(const Reply& reply, const Exchange& exchange, const AnswerForm& form) {
  std::string text;
  text.reserve(1536);
  text.append(answer_beginning).append(std::to_string(reply.status)).append(" ").append(reason_of(reply.status));
  text += "\r\n";
  add_date(text);
  for (const auto& [name, value] : reply.headers) add(text, name, value);
  if (!reply.type.empty()) add(text, "Content-Type", reply.type);
  // A 304 has no length: it would be that of the full answer.
  if (form.chunked) add(text, "Transfer-Encoding", "chunked");
  if (has_body(reply.status) && reply.stream == nullptr) add(text, "Content-Length", std::to_string(reply.size()));
  add(text, "Connection", form.close ? "close" : "keep-alive");
  add(text, "X-Request-Id", exchange.id);
  add_timings(text, reply, exchange);
  text.append("Content-Security-Policy: ").append(content_security_policy);
  text.append(reply.framed_by.empty() ? "'none'" : reply.framed_by).append("\r\n");
  add(text, "X-Content-Type-Options", "nosniff");
  add(text, "Referrer-Policy", "no-referrer");
  add(text, "Cross-Origin-Opener-Policy", "same-origin");
  add_sharing(text, reply, exchange);
  return text += "\r\n";
}

std::string chunk_of(std::string_view bytes, bool last) {
  std::array<char, 32> size{};
  std::string text;
  if (!bytes.empty()) {
    std::snprintf(size.data(), size.size(), "%zx\r\n", bytes.size());
    text.append(size.data()).append(bytes).append("\r\n");
  }
  return last ? text += "0\r\n\r\n" : text;
}

std::string_view last_resort() {
  static constexpr std::string_view answer =
      "HTTP/1.1 503 Service Unavailable\r\nContent-Type: application/problem+json\r\nContent-Length: 214\r\n"
      "Cache-Control: no-store\r\nRetry-After: 1\r\nX-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n"
      R"({"type":"/problems/out-of-memory","title":"The server is busy","status":503,)"
      R"("detail":"there is not enough memory for this now","errors":[{"code":"out-of-memory","detail":"there is not enough memory for this now"}]})";
  return answer;
}

}  // namespace dini::server
