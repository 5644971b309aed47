#pragma once

#include "graph/problem.h"

namespace dini {

/// What is wrong with a member of the request around a document; `pointer` leads to the member.
inline Problem request_problem(std::string pointer, std::string code, std::string detail) {
  return {.code = std::move(code), .detail = std::move(detail), .pointer = std::move(pointer), .in_request = true};
}

}  // namespace dini
