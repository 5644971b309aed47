#pragma once

#include "graph/lift.h"

namespace dini {

/// The field carried by a versor, or why it cannot be: it would be too large, or what carries it is no versor.
Attempt<SharedField> carried(const SharedField& field, const Versor& versor);

/// A field that was made, unless it is too large.
Attempt<SharedField> accepted(SharedField field, const char* port);

}  // namespace dini
