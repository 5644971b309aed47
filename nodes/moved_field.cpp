#include "nodes/moved_field.h"

#include "geometry/field_motion.h"

namespace dini {

Attempt<SharedField> accepted(SharedField field, const char* port) {
  if (std::optional<std::string> fault = too_large(field->size())) return Failure{"limit-exceeded", *fault, port};
  return field;
}

Attempt<SharedField> carried(const SharedField& field, const Versor& versor) {
  std::optional<SharedField> moved = moved_field(field, versor);
  if (!moved) {
    return Failure{"degenerate", "a field is carried by versors only, which take spheres to spheres and can be undone",
                   "shape"};
  }
  return accepted(*std::move(moved), "shape");
}

}  // namespace dini
