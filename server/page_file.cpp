#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"

namespace dini::server {

Operation describe_page() {
  return {.id = "page",
          .group = "Service",
          .title = "The editor, in which graphs are made",
          .doc = "The page in which graphs are made. Its files lie beside it.",
          .parameters = {if_none_match_header()},
          .answers = {{.doc = "The page.",
                       .contents = {{.type = "text/html"}},
                       .headers = {"ETag", "Cache-Control", "Vary"}},
                      not_modified()},
          .problems = {"not-found"}};
}

Reply page_file(const Context& context) {
  const Page::File* file = context.application.page.find(context.request().path);
  if (file == nullptr) {
    return problem_reply(Problem{.code = "not-found", .detail = "There is no such address."}, context.exchange());
  }
  Reply reply;
  reply.headers = {{"ETag", file->tag},
                   {"Cache-Control", file->immutable ? "public, max-age=31536000, immutable" : "no-cache"},
                   {"Vary", "Accept-Encoding"}};
  if (names_tag(context.request().header("If-None-Match"), file->tag)) {
    reply.status = 304;
    return reply;
  }
  reply.type = file->type;
  const bool packed = context.exchange().accepts_gzip && file->gzip != nullptr;
  if (packed) reply.headers.emplace_back("Content-Encoding", "gzip");
  reply.body = {packed ? file->gzip : file->bytes};
  return reply;
}

}  // namespace dini::server
