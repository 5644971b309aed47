#pragma once

#include <string>

#include "server/reply.h"
#include "server/request.h"

namespace dini::server {

/// Bytes that do not change while the server runs.
struct StaticAnswer {
  SharedBytes bytes;
  std::string tag;  ///< its entity tag, with quotes
};

StaticAnswer static_answer(std::string bytes);

/// Clients may keep it but must ask about it; 304 when they have it.
Reply static_reply(const Request& request, const StaticAnswer& answer, std::string_view type);

}  // namespace dini::server
