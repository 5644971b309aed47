#include "service/problem_json.h"

#include <string>

namespace dini {

namespace {

constexpr const char* graph_member = "/graph";

/// A patch of the document as one of the request around it.
Json patch_of_request(Json patch) {
  for (Json& step : patch) {
    for (const char* const member : {"path", "from"}) {
      if (step.contains(member)) step[member] = graph_member + step[member].get<std::string>();
    }
  }
  return patch;
}

}  // namespace

Json to_json(const Problems& problems, Sent sent) {
  Json list = Json::array();
  for (const Problem& problem : problems) {
    Json entry = {{"code", problem.code}, {"detail", problem.detail}};
    if (!problem.node.empty()) entry["node"] = problem.node;
    if (!problem.port.empty()) entry["port"] = problem.port;
    const bool moved = sent == Sent::request && !problem.in_request;
    if (problem.pointer) entry["pointer"] = (moved ? graph_member : "") + *problem.pointer;
    const bool applies = sent == Sent::request || !problem.in_request;
    if (applies && !problem.fix.is_null()) entry["fix"] = moved ? patch_of_request(problem.fix) : problem.fix;
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace dini
