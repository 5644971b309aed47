#pragma once

// A request as a thing that can be shown: the members of its JSON body. From it follow the strict reader, the schema in
// OpenAPI and the tables of docs/http.md. `request_type.h` makes one together with what reads it into a struct.

#include <string>
#include <vector>

#include "service/requests/member.h"

namespace dini {

struct RequestDescription {
  std::string name;  ///< of its schema: "EvaluateRequest"
  std::string doc;   ///< one sentence
  std::vector<Member> members = {};

  const Member* find(std::string_view member) const;
  std::vector<std::string> names() const;
};

/// The graph that stands in the examples of all requests, small enough to be read.
const Json& example_graph();

/// A JSON Schema (2020-12) of the body: an object without further members.
Json schema_of(const RequestDescription& request);

/// A body that asks for something: every member that has an example.
Json example_of(const RequestDescription& request);

/// What is wrong with a body; every problem, so that one answer names them all.
ProblemCollector faults_in(const RequestDescription& request, const Json& body);

}  // namespace dini
