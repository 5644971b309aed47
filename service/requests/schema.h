#pragma once

// JSON Schemas (2020-12) of what comes back, written as short as they are read.

#include <string>
#include <string_view>
#include <vector>

#include "graph/problem.h"

namespace dini::schema {

Json text(std::string doc);
/// The pattern of the names of kept graphs, or also of their versions (`chair@3`).
std::string graph_name_pattern(bool with_version);
Json word(std::vector<std::string> choices, std::string doc);
Json number(std::string doc);
Json whole(std::string doc);  ///< a whole number, not below 0
Json yes_no(std::string doc);
Json list(Json items, std::string doc);
Json map_of(Json values, std::string doc);  ///< an object with any names
Json anything(std::string doc);
/// The component of that name.
Json reference(std::string_view component, std::string doc = "");

struct Property {
  std::string name;
  Json schema;
  bool optional = false;
};

Json object(const std::vector<Property>& properties, std::string doc = "");

}  // namespace dini::schema
