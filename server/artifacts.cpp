#include "server/artifacts.h"

#include "server/handlers.h"
#include "server/hashed_files.h"
#include "server/responses.h"

namespace dini::server {
namespace {

Digest key_of(std::string_view sha256) { return DigestBuilder().text("artifact").text(sha256).finish(); }

/// A file that a job made, by its hash; null when none did.
Result<SharedFile> file_of_job(const Context& context, std::string_view name) {
  const auto sha256 = digest_from_hex(name);
  return sha256 ? context.application.jobs.kept().file(*sha256) : SharedFile();
}

}  // namespace

void Artifacts::add(const SharedFile& file) {
  files_.insert<File>(key_of(to_hex(file->sha256)), file, sizeof(File) + file->bytes->size());
}

SharedFile Artifacts::find(std::string_view sha256) { return files_.find<File>(key_of(sha256)); }

Operation describe_artifact() {
  std::vector<Content> contents;
  for (const FileFormat& format : usual_formats()) contents.push_back({.type = format.media_types.front()});
  return with_hashed_file({.id = "getArtifact",
                           .group = "Graphs",
                           .title = "A file that was made, by its hash",
                           .doc = "Answers with the bytes of a file that a sweep or an evaluation has made. They are "
                                  "kept while there is room (`artifact_bytes`), those of a job as long as what came "
                                  "of it; after that the graph has to be evaluated again.",
                           .problems = {"storage-failed"}},
                          contents);
}

Reply artifact(const Context& context) {
  const std::string& name = context.arguments.front();
  SharedFile file = context.application.artifacts.find(name);
  if (file == nullptr) {
    auto kept = file_of_job(context, name);
    if (!kept) return problem_reply(kept.problems(), context.exchange());
    file = *std::move(kept);
  }
  if (file == nullptr) {
    return problem_reply(
        Problem{.code = "not-found", .detail = "No file of that hash is kept here; evaluate its graph again."},
        context.exchange());
  }
  return hashed_file_reply(context, file->media_type, file->bytes, "inline", file->extension);
}

}  // namespace dini::server
