#include "server/responses.h"

#include <algorithm>
#include <array>

#include "server/text.h"
#include "service/engine.h"
#include "service/problem_codes.h"
#include "service/requests/excerpt.h"

namespace dini::server {
namespace {

struct StatusTitle {
  int status;
  std::string_view reason;
  std::string_view title;
};

constexpr std::array status_titles = {
    StatusTitle{200, "OK", ""},
    StatusTitle{201, "Created", ""},
    StatusTitle{204, "No Content", ""},
    StatusTitle{206, "Partial Content", ""},
    StatusTitle{304, "Not Modified", ""},
    StatusTitle{308, "Permanent Redirect", ""},
    StatusTitle{400, "Bad Request", "The request could not be read"},
    StatusTitle{401, "Unauthorized", "A token is needed"},
    StatusTitle{403, "Forbidden", "This page may not send requests here"},
    StatusTitle{404, "Not Found", "There is nothing here"},
    StatusTitle{405, "Method Not Allowed", "This address does not take that method"},
    StatusTitle{406, "Not Acceptable", "None of the accepted media types is available"},
    StatusTitle{408, "Request Timeout", "The request took too long to arrive"},
    StatusTitle{409, "Conflict", "A newer request replaced this one"},
    StatusTitle{411, "Length Required", "The length of the body is needed"},
    StatusTitle{412, "Precondition Failed", "What is kept is not what the request says"},
    StatusTitle{413, "Payload Too Large", "The body is too large"},
    StatusTitle{414, "URI Too Long", "The address is too long"},
    StatusTitle{415, "Unsupported Media Type", "The body has the wrong media type"},
    StatusTitle{416, "Range Not Satisfiable", "The file is shorter than that"},
    StatusTitle{417, "Expectation Failed", "The expectation cannot be met"},
    StatusTitle{421, "Misdirected Request", "This host is not served here"},
    StatusTitle{422, "Unprocessable Entity", ""},
    StatusTitle{428, "Precondition Required", "The request must say what it replaces"},
    StatusTitle{429, "Too Many Requests", "Too many wrong tokens"},
    StatusTitle{431, "Request Header Fields Too Large", "The headers are too large"},
    StatusTitle{499, "Client Closed Request", "The client left"},
    StatusTitle{500, "Internal Server Error", "The server made a mistake"},
    StatusTitle{503, "Service Unavailable", "The server is busy"},
    StatusTitle{504, "Gateway Timeout", "The deadline passed"},
    StatusTitle{505, "HTTP Version Not Supported", "This version of HTTP is not spoken here"},
    StatusTitle{507, "Insufficient Storage", "There is no room to keep this"},
};

const StatusTitle& title_of(int status) {
  const auto found = std::ranges::find(status_titles, status, &StatusTitle::status);
  return found != status_titles.end() ? *found : *std::ranges::find(status_titles, 500, &StatusTitle::status);
}

constexpr std::size_t detail_bytes = 200;

}  // namespace

int status_of(std::string_view code) {
  const ProblemCode* known = find_problem_code(code);
  return known != nullptr && known->status != 0 ? known->status : 422;
}

std::string_view reason_of(int status) { return title_of(status).reason; }

std::string title_of_code(std::string_view code) {
  const std::string_view of_status = title_of(status_of(code)).title;
  if (!of_status.empty()) return std::string(of_status);
  std::string words(code);
  std::ranges::replace(words, '-', ' ');
  words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

Reply problem_reply(const Problems& problems, const Exchange& exchange, const Json& blocked) {
  const Problem& first = problems.front();
  const int status = status_of(first.code);
  Reply reply = json_reply({{"type", std::string(exchange.base) + "/problems/" + first.code},
                            {"title", title_of_code(first.code)},
                            {"status", status},
                            {"detail", text_excerpt(first.detail, detail_bytes)},
                            {"instance", exchange.id},
                            {"errors", to_json(problems)},
                            {"blocked", blocked}},
                           status);
  reply.type = "application/problem+json";
  reply.headers.emplace_back("Cache-Control", "no-store");
  if (status == 503) reply.headers.emplace_back("Retry-After", "1");
  if (status == 401) reply.headers.emplace_back("WWW-Authenticate", "Bearer");
  return reply;
}

Reply problem_reply(Problem problem, const Exchange& exchange) {
  return problem_reply(Problems{std::move(problem)}, exchange);
}

Reply refusal(const Problem& problem, const Exchange& exchange) {
  Reply reply = problem_reply(problem, exchange);
  if (problem.code == "method-not-allowed") reply.headers.emplace_back("Allow", "GET, HEAD, POST");
  return reply;
}

Reply json_reply(const Json& json, int status) {
  return {.status = status, .type = "application/json", .body = {share(dump(json))}};
}

}  // namespace dini::server
