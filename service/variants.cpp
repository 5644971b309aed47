#include "service/variants.h"

#include <optional>

#include "graph/json_reader.h"
#include "graph/request_problem.h"

namespace dini {

namespace {

std::string place_of(const std::string& member, const std::string& name) {
  return "/" + member + "/" + pointer_token(name);
}

/// What is wrong with values that are listed by parameter.
Problems faults_in_lists(const Json& lists, const std::string& member, const Json& fixed) {
  Problems problems;
  if (lists.empty()) {
    problems.push_back(request_problem("/" + member, "required-input-missing", member + " names no parameter"));
  }
  for (const auto& [name, values] : lists.items()) {
    if (!values.is_array()) {
      problems.push_back(request_problem(place_of(member, name), "type-mismatch", name + " must be a list of values"));
    } else if (values.empty()) {
      problems.push_back(request_problem(place_of(member, name), "required-input-missing", name + " lists no value"));
    }
    if (fixed.contains(name)) {
      problems.push_back(request_problem(place_of(member, name), "out-of-range",
                                         name + " is given by parameters as well; one of them goes"));
    }
  }
  return problems;
}

Problems faults_in_settings(const Json& list, const Json& fixed) {
  Problems problems;
  if (list.empty()) problems.push_back(request_problem("/list", "required-input-missing", "list has no entry"));
  for (std::size_t i = 0; i < list.size() && problems.size() < 100; ++i) {
    const std::string place = "/list/" + std::to_string(i);
    for (const auto& [name, value] : list[i].items()) {
      if (!fixed.contains(name)) continue;
      problems.push_back(request_problem(place + "/" + pointer_token(name), "out-of-range",
                                         name + " is given by parameters as well; one of them goes"));
    }
  }
  return problems;
}

/// Of a grid; nothing when it is beyond all bounds.
std::optional<std::size_t> combinations(const Json& grid) {
  std::size_t count = 1;
  for (const auto& [name, values] : grid.items()) {
    if (__builtin_mul_overflow(count, values.size(), &count)) return std::nullopt;
  }
  return count;
}

}  // namespace

Result<Variants> Variants::read(const SweepAxes& axes, const Json& fixed, std::size_t most) {
  const int given = (axes.grid.is_null() ? 0 : 1) + (axes.zip.is_null() ? 0 : 1) + (axes.list.is_null() ? 0 : 1);
  if (given != 1) {
    return request_problem("", "required-input-missing",
                           given == 0 ? "a sweep needs a grid, a zip or a list of values for parameters"
                                      : "a sweep takes one of grid, zip and list, not several");
  }
  Variants variants;
  std::string member = "list";
  std::optional<std::size_t> size;
  if (!axes.list.is_null()) {
    if (Problems faults = faults_in_settings(axes.list, fixed); !faults.empty()) return faults;
    variants.values_ = axes.list;
    size = axes.list.size();
  } else {
    const bool is_grid = !axes.grid.is_null();
    member = is_grid ? "grid" : "zip";
    variants.kind_ = is_grid ? Kind::grid : Kind::zip;
    variants.values_ = is_grid ? axes.grid : axes.zip;
    if (Problems faults = faults_in_lists(variants.values_, member, fixed); !faults.empty()) return faults;
    size = is_grid ? combinations(variants.values_) : variants.values_.begin()->size();
    for (const auto& [name, values] : variants.values_.items()) {
      if (is_grid || values.size() == *size) continue;
      return request_problem(place_of(member, name), "axis-mismatch",
                             name + " lists " + std::to_string(values.size()) + " values but " +
                                 variants.values_.begin().key() + " lists " + std::to_string(*size) +
                                 "; the lists of a zip have one length");
    }
  }
  if (!size || *size > most) {
    return request_problem("/" + member, "limit-exceeded",
                           "there are " + (size ? std::to_string(*size) : "too many") + " variants, at most " +
                               std::to_string(most) + " are accepted");
  }
  variants.size_ = *size;
  return variants;
}

Json Variants::at(std::size_t index) const {
  if (kind_ == Kind::list) return values_[index];
  Json setting = Json::object();
  std::size_t rest = index;
  for (auto entry = values_.rbegin(); entry != values_.rend(); ++entry) {
    const Json& values = entry.value();
    setting[entry.key()] = values[kind_ == Kind::zip ? index : rest % values.size()];
    rest /= values.size();
  }
  return setting;
}

}  // namespace dini
