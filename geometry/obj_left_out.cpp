#include "geometry/obj_left_out.h"

#include <algorithm>

#include "geometry/counted.h"
#include "geometry/imported_mesh.h"

namespace dini {

namespace {

/// What changes no triangle: names, groups, smoothing and display, and what only free-form shapes use.
bool changes_nothing(std::string_view keyword) {
  constexpr std::array<std::string_view, 35> words = {
      "o",          "g",     "s",    "mg",   "mtllib", "maplib", "usemap", "lod",      "bevel",
      "c_interp",   "vp",    "deg",  "bmat", "step",   "cstype", "parm",   "d_interp", "trace_obj",
      "shadow_obj", "ctech", "trim", "hole", "scrv",   "sp",     "end",    "con",      "stech",
      "curv2",      "cdc",   "cdp",  "bsp",  "bzp",    "res",    "call",   "csh"};
  return std::ranges::find(words, keyword) != words.end();
}

}  // namespace

void ObjLeftOut::add(std::string_view keyword, std::size_t line) {
  if (keyword == "p") {
    ++points_;
  } else if (keyword == "l") {
    ++lines_;
  } else if (keyword == "curv" || keyword == "surf") {
    ++free_forms_;
  } else if (keyword == "usemtl") {
    ++materials_;
  } else if (!changes_nothing(keyword) && unknown_++ == 0) {
    first_unknown_ = line;
  }
}

void ObjLeftOut::warn(std::vector<std::string>& warnings) const {
  const auto tell = [&](std::size_t count, std::string_view one, std::string_view many, const std::string& end) {
    if (count > 0) warnings.push_back(counted(count, one, many) + end);
  };
  tell(points_, "statement of points (p) is", "statements of points (p) are", " left out");
  tell(lines_, "line (l) is", "lines (l) are", " left out");
  tell(free_forms_, "free-form curve or surface is", "free-form curves and surfaces are", " left out");
  tell(materials_, "use of a material is", "uses of materials are", " left out");
  tell(weights_, "vertex has", "vertices have", " a weight or other numbers behind the position, which are left out");
  tell(depths_, "third texture coordinate is", "third texture coordinates are", " left out");
  tell(unknown_, "line is", "lines are",
       " no statement of an OBJ and left out, the first is line " + std::to_string(first_unknown_));
}

}  // namespace dini
