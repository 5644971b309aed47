#include "service/limit_table.h"

#include <array>
#include <cctype>

#include "graph/field_count.h"

namespace dini {
namespace {

constexpr std::uint64_t million = 1'000'000;

constexpr std::array all_limits = {
    Limit<Limits>{"body_bytes", "bytes", &Limits::body_bytes, "of a JSON body"},
    Limit<Limits>{"json_depth", "levels", &Limits::json_depth, "of nesting in a JSON body", 4, 256},
    Limit<Limits>{"json_values", "values", &Limits::json_values, "in a JSON body"},
    Limit<Limits>{"string_bytes", "bytes", &Limits::string_bytes, "of one text in a JSON body"},
    Limit<Limits>{"nodes", "nodes", &Limits::nodes, "in a graph", 1, million},
    Limit<Limits>{"links", "links", &Limits::links, "in a graph", 1, million},
    Limit<Limits>{"samples", "values", &Limits::samples, "on one wire", 1, 1000 * million},
    Limit<Limits>{"vertices", "vertices", &Limits::vertices, "of one result", 1, 100 * million},
    Limit<Limits>{"triangles", "triangles", &Limits::triangles, "of one result", 1, 200 * million},
    Limit<Limits>{"request_bytes", "bytes", &Limits::request_bytes, "of memory predicted for one evaluation"},
    Limit<Limits>{"work", "ns", &Limits::work, "of one processor predicted for one evaluation", 1,
                  std::uint64_t{1} << 50},
    Limit<Limits>{"sweep_variants", "variants", &Limits::sweep_variants, "of one sweep", 1, 10 * million},
    Limit<Limits>{"sweep_work", "ns", &Limits::sweep_work, "of one processor predicted for one sweep", 1,
                  std::uint64_t{1} << 60},
    Limit<Limits>{"cache_bytes", "bytes", &Limits::cache_bytes, "of memory for results that are kept", 0},
    Limit<Limits>{"interactive_milliseconds", "ms", &Limits::interactive_milliseconds,
                  "from the first byte of a request to the end of its work", 1, 24 * 3600 * 1000},
    Limit<Limits>{"sweep_milliseconds", "ms", &Limits::sweep_milliseconds,
                  "from the first byte of a sweep to the end of its work", 1, 7 * 24 * 3600 * 1000},
    Limit<Limits>{"previews", "entries", &Limits::previews, "of `preview` in one request", 1, 10'000},
    Limit<Limits>{"preview_elements", "elements", &Limits::preview_elements, "drawn of one previewed output", 1,
                  million},
    Limit<Limits>{"preview_points", "points", &Limits::preview_points,
                  "that stand alone, drawn of one previewed output", 1, 10 * million},
    Limit<Limits>{"measures", "entries", &Limits::measures, "of `measures` in one request", 1, 10'000},
    Limit<Limits>{"measured_values", "values", &Limits::measured_values, "of one measure", 1, million},
    Limit<Limits>{"asset_bytes", "bytes", &Limits::asset_bytes, "of one uploaded file", 1, std::uint64_t{1} << 31},
    Limit<Limits>{"asset_vertices", "vertices", &Limits::asset_vertices, "in one file, after seams are split", 1,
                  100 * million},
    Limit<Limits>{"asset_triangles", "triangles", &Limits::asset_triangles, "in one file", 1, 200 * million},
    Limit<Limits>{"asset_store_bytes", "bytes", &Limits::asset_store_bytes,
                  "of memory for all uploaded meshes; the least recently used go first", 0},
};

static_assert(all_limits.size() == field_count<Limits>(), "every member of Limits is in the table");

}  // namespace

std::string flag_of(std::string_view limit) {
  std::string flag = "--";
  for (const char c : limit) flag += c == '_' ? '-' : c;
  return flag;
}

std::string variable_of(std::string_view limit) {
  std::string variable = "DINI_";
  for (const char c : limit) variable += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return variable;
}

std::span<const Limit<Limits>> evaluation_limits() { return all_limits; }

}  // namespace dini
