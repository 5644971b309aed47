#pragma once

// What people and programs are told of a route. Every handler has one beside it; the table of routes holds both, and
// from it follow GET /openapi.json, GET /docs and the tables of docs/http.md.

#include <string>
#include <string_view>
#include <vector>

#include "service/problem_codes.h"
#include "service/requests/description.h"

namespace dini::server {

/// A part of a request beside its body.
struct Parameter {
  enum class Place { path, query, header };
  Place place;
  std::string name;
  std::string doc;  ///< one sentence
  Json schema = {{"type", "string"}};
  Json example = nullptr;
};

/// "path", "query" or "header".
std::string_view name_of(Parameter::Place place);

/// A body in one media type.
struct Content {
  std::string type;
  Json schema = nullptr;   ///< null for bytes that are no JSON
  Json example = nullptr;  ///< null for none
};

/// What is answered when all is well.
struct Answer {
  int status = 200;
  std::string doc;  ///< one sentence
  std::vector<Content> contents = {};
  std::vector<std::string> headers = {};  ///< names of `answer_headers`
};

struct Operation {
  std::string id;     ///< of the operation in clients: camelCase
  std::string group;  ///< what it stands with: a tag in OpenAPI
  std::string title;  ///< a few words
  std::string doc;    ///< sentences
  std::vector<Parameter> parameters = {};
  const RequestDescription* request = nullptr;     ///< of a JSON body
  const RequestDescription* or_request = nullptr;  ///< of another one that may be sent instead
  bool takes_document = false;                     ///< the body is a graph document
  std::vector<std::string> file_types = {};        ///< media types of a body that is a file
  std::vector<Answer> answers = {};
  std::vector<std::string_view> problems = {};  ///< codes of its own; `every_problem` adds those of HTTP
  /// Its query may have any names: the handler reads them, as those of a graph's parameters, or passes over them, as a
  /// probe does, to which monitors add the time.
  bool takes_any_query = false;
  bool computes = false;  ///< its work waits for a place, and may be stopped

  bool has_body() const { return request != nullptr || takes_document || !file_types.empty(); }
};

/// A header of answers.
struct AnswerHeader {
  std::string_view name;
  std::string_view doc;
};

std::span<const AnswerHeader> answer_headers();

/// The headers that requests may carry, described once for all routes that look at them.
Parameter accept_header(std::string doc);
Parameter if_none_match_header();
Parameter supersede_key_header();
Parameter supersede_header();

/// The answer 304, and the two headers that go with it.
Answer not_modified();

/// The codes of a kind, and some more.
std::vector<std::string_view> codes_of(ProblemKind kind, const std::vector<std::string_view>& more = {});

/// Every code that the operation may answer at that method and path, in the order of `problem_codes`.
std::vector<std::string_view> every_problem(const Operation& operation, std::string_view method, std::string_view path);

}  // namespace dini::server
