#include "fitting/determination.h"

#include <cmath>

namespace dini::fitting {
namespace {

constexpr double least_rise = 1e-4;
/// Of a direction of length 1: what is below hardly takes part.
constexpr double least_share = 0.2;

}  // namespace

std::vector<Undetermined> undetermined_by(const SymmetricMatrix& rise, const std::vector<Varied>& varied) {
  std::vector<Undetermined> found;
  for (const EigenPair& pair : eigen_pairs(rise)) {
    if (pair.value >= least_rise * least_rise) break;
    Undetermined each;
    std::string list;
    for (std::size_t k = 0; k < varied.size(); ++k) {
      if (std::abs(pair.vector[k]) < least_share) continue;
      each.parameters.push_back(varied[k].name);
      list += (list.empty() ? "" : " and ") + varied[k].name;
    }
    each.detail = each.parameters.size() == 1
                      ? list + " hardly changes what is asked for; any value near this one does as well"
                      : list + " change together without changing what is asked for; other values do as well";
    found.push_back(std::move(each));
  }
  return found;
}

}  // namespace dini::fitting
