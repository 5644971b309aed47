#pragma once

#include "server/network.h"
#include "server/reply.h"
#include "server/request.h"
#include "server/settings.h"

namespace dini::server {

/// Takes over what a proxy says of who has asked it: the client's address from `X-Forwarded-For`, its scheme from
/// `X-Forwarded-Proto`, and the name that it asked for from `X-Forwarded-Host`, which stands for `Host` from then on.
/// Of anybody but a trusted proxy all three are passed over, and of those that several proxies have added to, what was
/// added by the last one before the first that is not trusted.
void take_forwarding(const std::optional<Address>& peer, const Settings& settings, Request& request,
                     Exchange& exchange);

}  // namespace dini::server
