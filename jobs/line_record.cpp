#include "jobs/line_record.h"

#include "service/engine.h"

namespace dini::jobs {
namespace {

Json json_of(const File& file) {
  return {{"media_type", file.media_type}, {"extension", file.extension}, {"sha256", to_hex(file.sha256)},
          {"bytes", file.bytes->size()},   {"vertices", file.vertices},   {"triangles", file.triangles}};
}

}  // namespace

std::string line_record(const store::JobLine& line) {
  Json head = {{"failed", line.failed}, {"text", line.text}, {"files", Json::array()}};
  for (const SharedFile& file : line.files) head["files"].push_back(json_of(*file));
  std::string record = dump(head) + "\n";
  for (const SharedFile& file : line.files) record += *file->bytes;
  return record;
}

std::optional<store::JobLine> read_line_record(std::size_t index, std::string_view record) try {
  const auto end = record.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const Json head = Json::parse(record.substr(0, end));
  record.remove_prefix(end + 1);
  store::JobLine line{
      .index = index, .failed = head.at("failed").get<bool>(), .text = head.at("text").get<std::string>()};
  for (const Json& told : head.at("files")) {
    const auto sha256 = digest_from_hex(told.at("sha256").get<std::string>());
    const auto bytes = told.at("bytes").get<std::size_t>();
    if (!sha256 || bytes > record.size()) return std::nullopt;
    File file{.media_type = told.at("media_type").get<std::string>(),
              .extension = told.at("extension").get<std::string>(),
              .bytes = share(std::string(record.substr(0, bytes))),
              .sha256 = *sha256};
    file.vertices = told.at("vertices").get<std::size_t>();
    file.triangles = told.at("triangles").get<std::size_t>();
    line.files.push_back(std::make_shared<const File>(std::move(file)));
    record.remove_prefix(bytes);
  }
  return record.empty() ? std::optional(std::move(line)) : std::nullopt;
} catch (const Json::exception&) {
  return std::nullopt;
}

}  // namespace dini::jobs
