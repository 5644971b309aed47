#include "geometry/json.h"

namespace nlohmann {

template class basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, double,
                          dini::JsonAllocator>;
template class detail::serializer<dini::Json>;

}  // namespace nlohmann
