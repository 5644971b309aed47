#include "server/graphs.h"
#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"

namespace dini::server {
namespace {

Reply no_page(const Context& context) {
  return problem_reply(Problem{.code = "not-found", .detail = "There is no such address."}, context.exchange());
}

Reply file_reply(const Context& context, const Page::File& file) {
  Reply reply;
  reply.headers = {{"ETag", file.tag},
                   {"Cache-Control", file.immutable ? "public, max-age=31536000, immutable" : "no-cache"},
                   {"Vary", "Accept-Encoding"}};
  if (names_tag(context.request().header("If-None-Match"), file.tag)) {
    reply.status = 304;
    return reply;
  }
  reply.type = file.type;
  const bool packed = context.exchange().accepts_gzip && file.gzip != nullptr;
  if (packed) reply.headers.emplace_back("Content-Encoding", "gzip");
  reply.body = {packed ? file.gzip : file.bytes};
  return reply;
}

/// Whose pages may have an answer in a frame, as `frame-ancestors` says it: our own, and those that are let in.
std::string frame_ancestors(const Settings& settings) {
  std::string sources = "'self'";
  for (const std::string& origin : settings.allowed_origins) sources += " " + origin;
  return sources;
}

/// Whether it may be told that there is no such graph: who has no token is not told which there are.
bool is_known_missing(const Context& context) {
  if (!context.application.settings.token.empty()) return false;
  const auto version = stored_version(context, context.arguments.front());
  return !version && version.problems().front().code == "not-found";
}

}  // namespace

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
          .problems = {"not-found"},
          .takes_any_query = true};
}

Reply page_file(const Context& context) {
  const Page::File* file = context.application.page.find(context.request().path);
  return file != nullptr ? file_reply(context, *file) : no_page(context);
}

Operation describe_embed_page() {
  return {.id = "embedPage",
          .group = "Stored graphs",
          .title = "A model with its sliders, for a frame of another page",
          .doc =
              "A small page that shows an output of a graph, and sliders for its parameters. The query has values to "
              "begin with (`?height=0.9`, as the address of an output has them), `output` for one of several, and "
              "`theme=light` or `dark`; a parameter that is called like one of these two is written "
              "`parameter.theme`. Pages of the server itself and of the origins of `--allow-origin` may show it in a "
              "frame.",
          .parameters = {graph_parameter(true), if_none_match_header()},
          .answers = {{.doc = "The page.",
                       .contents = {{.type = "text/html"}},
                       .headers = {"ETag", "Cache-Control", "Vary"}},
                      not_modified(),
                      {.status = 404,
                       .doc = "A page that says that there is no such graph.",
                       .contents = {{.type = "text/html"}}}},
          .takes_any_query = true};
}

Reply embed_page(const Context& context) {
  const Page::File* file = context.application.page.find("/embed/index.html");
  if (file == nullptr) return no_page(context);
  const bool is_missing = is_known_missing(context);
  Reply reply =
      is_missing ? Reply{.status = 404, .type = file->type, .body = {file->bytes}} : file_reply(context, *file);
  if (is_missing) reply.headers.emplace_back("Cache-Control", "no-store");
  reply.framed_by = frame_ancestors(context.application.settings);
  return reply;
}

}  // namespace dini::server
