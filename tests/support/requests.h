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

/// What is asked for, as tests write it: with the document of its graph.
struct Asked {
  Json graph;
  Json parameters = Json::object();
  std::string output = {};
  Quality quality = Quality::final;
  std::optional<std::int64_t> triangle_budget = {};
  std::vector<std::string> preview = {};
  std::vector<std::string> measures = {};
  bool parts = false;
  bool without_output = false;
  std::string format = {};
  bool draco = true;
  bool embed_graph = false;
};

inline EvaluateRequest request_to(const Engine& engine, const Asked& asked) {
  return {.graph = engine.read(asked.graph),
          .parameters = asked.parameters,
          .output = asked.output,
          .quality = asked.quality,
          .triangle_budget = asked.triangle_budget,
          .preview = asked.preview,
          .measures = asked.measures,
          .parts = asked.parts,
          .without_output = asked.without_output,
          .format = asked.format,
          .draco = asked.draco,
          .embed_graph = asked.embed_graph,
          .notes = notes_of(asked.graph)};
}

inline Result<SharedPrepared> prepared_for(const Engine& engine, const Asked& asked, const Cancel& cancel = Cancel()) {
  return engine.prepare(request_to(engine, asked), cancel);
}

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
      .graph = engine.read(graph), .parameters = parameters, .node = place.substr(0, dot), .output = output};
  const Result<SharedBytes> answer = engine.inspect(request, Job());
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
inline Result<Answered> answered(const Engine& engine, const Asked& asked, const Job& job = Job()) {
  const auto ready = prepared_for(engine, asked, job.cancel);
  if (!ready) return ready.problems();
  const auto computed = engine.compute(**ready, job);
  if (!computed) return computed.problems();
  const auto bytes_of = [](const SharedFile& file) { return file == nullptr ? nullptr : file->bytes; };
  return Answered{*ready, *computed, bytes_of((*computed)->model), bytes_of((*computed)->preview),
                  [&engine, prepared = *ready, computed = *computed] { return engine.report(*prepared, *computed); }};
}

/// The file of a request that must succeed.
inline std::string file_of(const Engine& engine, const Asked& asked) {
  const Result<Answered> answer = answered(engine, asked);
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
