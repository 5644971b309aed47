#pragma once

// How problems become answers. The only place that knows both the codes of problems and the statuses of HTTP.

#include <string>
#include <string_view>

#include "graph/problem.h"
#include "server/reply.h"

namespace dini::server {

/// The status for a problem code; 422 for every code that speaks about a graph or its values.
int status_of(std::string_view code);

/// The reason phrase of every status that there is.
std::string_view reason_of(int status);

/// What kind of problem a code is, in a few words: that of its status, and for 422, which has codes of many kinds, the
/// words of the code itself.
std::string title_of_code(std::string_view code);

/// An RFC 9457 answer. The first problem decides status, type and detail; all of them are listed. `blocked` names the
/// nodes that are well in themselves but stand behind one that is not.
Reply problem_reply(const Problems& problems, const Exchange& exchange, const Json& blocked = Json::array());
Reply problem_reply(Problem problem, const Exchange& exchange);

/// The answer to a request that never reaches a handler.
Reply refusal(const Problem& problem, const Exchange& exchange);

/// A JSON answer. Bytes that are not UTF-8 are replaced, never thrown about.
Reply json_reply(const Json& json, int status = 200);

}  // namespace dini::server
