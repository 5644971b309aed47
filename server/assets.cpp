#include <algorithm>
#include <array>

#include "server/computing.h"
#include "server/handlers.h"
#include "server/hashed_files.h"
#include "server/responses.h"
#include "server/text.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

/// The content tells the format; the type only keeps out what web forms send on their own.
constexpr std::array<std::string_view, 12> mesh_types = {
    "application/octet-stream", "model/gltf-binary", "model/obj",       "application/x-ply",
    "application/ply",          "model/ply",         "model/x-ply",     "model/stl",
    "model/x.stl-binary",       "model/x.stl-ascii", "application/sla", "text/plain",
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
  return {
      .id = "addAsset",
      .group = "Files",
      .title = "Takes a mesh file for the node `import`",
      .doc =
          "Keeps a mesh file (OBJ, PLY, STL or GLB, told by its content) for graphs that name it by its hash in a node "
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
                                      "model/stl, application/x-ply or text/plain."}});
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
  return with_hashed_file({.id = "getAsset",
                           .group = "Files",
                           .title = "A mesh file that was uploaded, by its hash",
                           .doc = "Answers with the file, byte for byte as it was sent. `HEAD` tells whether it is "
                                  "here, or has to be uploaded."},
                          {{.type = "application/octet-stream"}});
}

Reply asset(const Context& context) {
  SharedBytes bytes = context.engine().asset(context.arguments.front());
  if (bytes == nullptr) {
    return problem_reply(
        Problem{.code = "not-found", .detail = "No file of that hash is here; upload it to /v1/assets."},
        context.exchange());
  }
  return hashed_file_reply(context, "application/octet-stream", std::move(bytes), "attachment");
}

}  // namespace dini::server
