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
    FAIL_CHECK(problem.code << " at " << problem.node << "." << problem.port << " " << problem.pointer << ": "
                            << problem.detail);
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
  const Result<Json> answer = engine.inspect(request, Cancel());
  require_none(answer ? Problems{} : answer.problems());
  return answer->at("values");
}

/// A request from checking to the file; the problems of whichever stage has some.
inline Result<Evaluated> answered(const Engine& engine, const EvaluateRequest& request,
                                  const Cancel& cancel = Cancel()) {
  const auto prepared = engine.prepare(request);
  if (!prepared) return prepared.problems();
  return engine.evaluate(**prepared, cancel);
}

/// The file of a request that must succeed.
inline std::string file_of(const Engine& engine, const EvaluateRequest& request) {
  const Result<Evaluated> answer = answered(engine, request);
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
