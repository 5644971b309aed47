#include "server/static_answer.h"

#include "server/negotiation.h"
#include "server/text.h"

namespace dini::server {

StaticAnswer static_answer(std::string bytes) {
  std::string tag = "\"" + content_hash(bytes) + "\"";
  return {share(std::move(bytes)), std::move(tag)};
}

Reply static_reply(const Request& request, const StaticAnswer& answer, std::string_view type) {
  Reply reply;
  reply.headers = {{"ETag", answer.tag}, {"Cache-Control", "no-cache"}, {"Vary", "Accept-Encoding"}};
  if (names_tag(request.header("If-None-Match"), answer.tag)) {
    reply.status = 304;
  } else {
    reply.type = type;
    reply.body = {answer.bytes};
  }
  return reply;
}

}  // namespace dini::server
