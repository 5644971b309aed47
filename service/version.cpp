#include "service/version.h"

namespace dini {

const char* const engine_version = DINI_VERSION;

}  // namespace dini
