#include "server/hashed_files.h"

#include "server/negotiation.h"
#include "server/ranges.h"

namespace dini::server {

Operation with_hashed_file(Operation operation, const std::vector<Content>& contents) {
  operation.parameters = {{.place = Parameter::Place::path,
                           .name = "sha256",
                           .doc = "The SHA-256 of the file, 64 hexadecimal digits in lower case.",
                           .schema = {{"type", "string"}, {"pattern", "^[0-9a-f]{64}$"}},
                           .example = std::string(64, '0')},
                          if_none_match_header(),
                          range_header()};
  operation.answers = {{.doc = "The file.",
                        .contents = contents,
                        .headers = {"ETag", "Cache-Control", "Accept-Ranges", "Content-Disposition"}},
                       {.status = 206,
                        .doc = "The part that `Range` names.",
                        .contents = contents,
                        .headers = {"ETag", "Cache-Control", "Accept-Ranges", "Content-Range"}},
                       not_modified()};
  operation.problems.insert(operation.problems.end(), {"not-found", "range-not-satisfiable"});
  return operation;
}

Reply hashed_file_reply(const Context& context, const std::string& type, SharedBytes bytes,
                        const std::string& disposition, const std::string& extension) {
  const std::string& name = context.arguments.front();
  const std::string tag = "\"" + name + "\"";
  Reply reply{.headers = {{"ETag", tag}, {"Cache-Control", "public, max-age=31536000, immutable"}}};
  if (names_tag(context.request().header("If-None-Match"), tag)) {
    reply.status = 304;
    return reply;
  }
  reply.type = type;
  reply.body = {std::move(bytes)};
  reply.headers.emplace_back("Content-Disposition",
                             disposition + "; filename=\"" + name.substr(0, 16) + extension + "\"");
  return with_range(std::move(reply), context, tag);
}

}  // namespace dini::server
