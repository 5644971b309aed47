#pragma once

// Requests to a real engine, and graphs to make them with.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "service/engine.h"
#include "tests/support/documents.h"

namespace dini::support {

/// Fails the test when there are problems, and shows them.
inline void require_none(const Problems& problems) {
  for (const Problem& problem : problems) {
    FAIL_CHECK(problem.code << " at " << problem.node << "." << problem.port << " " << problem.pointer.value_or("")
                            << ": " << problem.detail);
  }
  REQUIRE(problems.empty());
}

/// The values that `inspect` shows at "node" or "node.output".
inline Json inspected(const Engine& engine, const Json& graph, const std::string& place,
                      const Json& parameters = Json::object()) {
  const std::size_t dot = place.find('.');
  const std::string output = dot == std::string::npos ? "" : place.substr(dot + 1);
  const InspectRequest request{
      .graph = graph, .parameters = parameters, .node = place.substr(0, dot), .output = output};
  const Result<SharedBytes> answer = engine.inspect(request, Cancel());
  require_none(answer ? Problems{} : answer.problems());
  return Json::parse(**answer).at("values");
}

/// An answer with what its request got.
struct Answered {
  SharedPrepared prepared;
  SharedComputed computed;
  SharedBytes glb;      ///< null without an output
  SharedBytes preview;  ///< null when none were asked for
  std::function<Json()> report;
};

/// A request from checking to the file; the problems of whichever stage has some.
inline Result<Answered> answered(const Engine& engine, const EvaluateRequest& request,
                                 const Cancel& cancel = Cancel()) {
  const auto prepared = engine.prepare(request, cancel);
  if (!prepared) return prepared.problems();
  const auto computed = engine.compute(**prepared, cancel);
  if (!computed) return computed.problems();
  const auto bytes_of = [](const SharedFile& file) { return file == nullptr ? nullptr : file->bytes; };
  return Answered{
      *prepared, *computed, bytes_of((*computed)->model), bytes_of((*computed)->preview),
      [&engine, prepared = *prepared, computed = *computed] { return engine.report(*prepared, *computed); }};
}

/// The file of a request that must succeed.
inline std::string file_of(const Engine& engine, const EvaluateRequest& request) {
  const Result<Answered> answer = answered(engine, request);
  require_none(answer ? Problems{} : answer.problems());
  return *answer->glb;
}

/// The example graphs of a folder by id; the program that uses it defines DINI_EXAMPLES.
inline std::map<std::string, Json> examples(const std::string& folder = DINI_EXAMPLES) {
  std::map<std::string, Json> all;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json")
      all[entry.path().stem().string()] = Json::parse(std::ifstream(entry.path()));
  }
  return all;
}

}  // namespace dini::support
