#include <algorithm>
#include <array>

#include "server/computing.h"
#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/ranges.h"
#include "server/responses.h"
#include "server/text.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

/// The content tells the format; the type only keeps out what web forms send on their own.
constexpr std::array<std::string_view, 8> mesh_types = {
    "application/octet-stream", "model/gltf-binary", "model/obj",   "application/x-ply",
    "application/ply",          "model/ply",         "model/x-ply", "text/plain",
};

bool is_mesh_type(std::string_view type) {
  return std::ranges::any_of(mesh_types, [&](std::string_view known) { return equal_ignoring_case(known, type); });
}

Reply added_reply(const AssetSummary& added) {
  Reply reply = json_reply({{"sha256", added.sha256},
                            {"bytes", added.bytes},
                            {"format", added.format},
                            {"vertices", added.vertices},
                            {"triangles", added.triangles},
                            {"warnings", added.warnings}},
                           201);
  reply.headers.emplace_back("Cache-Control", "no-store");
  return reply;
}

}  // namespace

Operation describe_add_asset() {
  return {.id = "addAsset",
          .group = "Files",
          .title = "Takes a mesh file for the node `import`",
          .doc =
              "Keeps a mesh file (OBJ, PLY or GLB, told by its content) for graphs that name it by its hash in a node "
              "`import`. They outlive the server where graphs do. When there is no more room (`asset_file_bytes` on "
              "the disk, `asset_store_bytes` in memory), the files that were used longest ago go; from the disk none "
              "that a stored graph names.",
          .parameters = {supersede_key_header()},
          .file_types = {mesh_types.begin(), mesh_types.end()},
          .answers = {{.status = 201,
                       .doc = "What is known of the file.",
                       .contents = {{.type = "application/json",
                                     .schema = schema::reference("AssetSummary"),
                                     .example = {{"sha256", std::string(64, '0')},
                                                 {"bytes", 35128},
                                                 {"format", "obj"},
                                                 {"vertices", 397},
                                                 {"triangles", 736},
                                                 {"warnings", {"1 line (l) is left out"}}}}},
                       .headers = {"Cache-Control"}}},
          .problems = {"invalid-asset", "limit-exceeded", "storage-full", "storage-failed"},
          .computes = true};
}

void add_asset(const Context& context) {
  const std::string_view type = context.request().header("Content-Type");
  if (!is_mesh_type(trim(type.substr(0, type.find(';'))))) {
    return reply_problems(context,
                          {{.code = "unsupported-media-type",
                            .detail = "Send the file itself as application/octet-stream, model/gltf-binary, model/obj, "
                                      "application/x-ply or text/plain."}});
  }
  const Digest key = DigestBuilder().text("asset").digest(sha256(context.request().body)).finish();
  compute<AssetSummary>(
      context, {.key = key, .deadline = deadline_of(context, std::nullopt)},
      [context](const Job& job) -> Result<std::shared_ptr<const AssetSummary>> {
        auto added = context.engine().add_asset(context.request().body, "", job.cancel);
        if (!added) return std::move(added).problems();
        return std::make_shared<const AssetSummary>(*std::move(added));
      },
      [](const std::shared_ptr<const AssetSummary>& added) { return added_reply(*added); });
}

Operation describe_asset() {
  const std::vector<Content> contents = {{.type = "application/octet-stream"}};
  return {.id = "getAsset",
          .group = "Files",
          .title = "A mesh file that was uploaded, by its hash",
          .doc =
              "Answers with the file, byte for byte as it was sent. `HEAD` tells whether it is here, or has to be "
              "uploaded.",
          .parameters = {{.place = Parameter::Place::path,
                          .name = "sha256",
                          .doc = "The SHA-256 of the file, 64 hexadecimal digits in lower case.",
                          .schema = {{"type", "string"}, {"pattern", "^[0-9a-f]{64}$"}},
                          .example = std::string(64, '0')},
                         if_none_match_header(),
                         range_header()},
          .answers = {{.doc = "The file.",
                       .contents = contents,
                       .headers = {"ETag", "Cache-Control", "Accept-Ranges", "Content-Disposition"}},
                      {.status = 206,
                       .doc = "The part that `Range` names.",
                       .contents = contents,
                       .headers = {"ETag", "Cache-Control", "Accept-Ranges", "Content-Range"}},
                      not_modified()},
          .problems = {"not-found", "range-not-satisfiable"}};
}

Reply asset(const Context& context) {
  const std::string& name = context.arguments.front();
  SharedBytes bytes = context.engine().asset(name);
  if (bytes == nullptr) {
    return problem_reply(
        Problem{.code = "not-found", .detail = "No file of that hash is here; upload it to /v1/assets."},
        context.exchange());
  }
  const std::string tag = "\"" + name + "\"";
  Reply reply{.headers = {{"ETag", tag}, {"Cache-Control", "public, max-age=31536000, immutable"}}};
  if (names_tag(context.request().header("If-None-Match"), tag)) {
    reply.status = 304;
    return reply;
  }
  reply.type = "application/octet-stream";
  reply.body = {std::move(bytes)};
  reply.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + name.substr(0, 16) + "\"");
  return with_range(std::move(reply), context, tag);
}

}  // namespace dini::server
