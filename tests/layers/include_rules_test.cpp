#include "tests/layers/include_rules.h"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace dini;
using namespace dini::support;

namespace {

const LayerRule& rule_of(std::string_view layer) {
  const auto rules = layer_rules();
  return *std::find_if(rules.begin(), rules.end(), [&](const LayerRule& rule) { return rule.layer == layer; });
}

std::vector<std::string> wrong_in(std::string_view layer, const std::string& text) {
  return wrong_includes({std::string(layer) + "/made_up.cpp", text}, rule_of(layer));
}

TEST_CASE("Every include follows the order of the layers") {
  for (const LayerRule& rule : layer_rules()) {
    std::size_t sources = 0;
    for (const SourceFile& file : read_source_files(DINI_SOURCE_DIR, std::string(rule.layer))) {
      if (!file.path.ends_with(".h") && !file.path.ends_with(".cpp")) continue;
      ++sources;
      for (const std::string& wrong : wrong_includes(file, rule)) FAIL_CHECK(wrong);
    }
    INFO("layer " << rule.layer);
    CHECK(sources > 0);
  }
}

TEST_CASE("An include against the order is found with its line") {
  CHECK(wrong_in("algebra", "#pragma once\n\n#include \"geometry/mesh.h\"\n") ==
        std::vector<std::string>{"algebra/made_up.cpp:3: the layer algebra may not include \"geometry/mesh.h\""});
  CHECK(wrong_in("graph", "#include \"nodes/all.h\"").size() == 1);
  CHECK(wrong_in("gltf", "#include \"graph/value.h\"").size() == 1);
  CHECK(wrong_in("service", "#include \"server/server.h\"\n#include \"cli/options.h\"\n").size() == 2);
  CHECK(wrong_in("geometry", "#include \"tests/support/meshes.h\"").size() == 1);
}

TEST_CASE("An include against the order is found however it is written") {
  CHECK(wrong_in("algebra", "  #  include  <geometry/mesh.h>  // why").size() == 1);
  CHECK(wrong_in("algebra", "\t#include\"geometry/mesh.h\"").size() == 1);
  CHECK(wrong_in("algebra", "#if 1\r\n#include \"geometry/mesh.h\"\r\n#endif\r\n").size() == 1);
}

TEST_CASE("A layer may include itself, what lies below it, and libraries") {
  CHECK(wrong_in("algebra", "#include \"algebra/vector.h\"\n#include <vector>\n#include <hwy/highway.h>\n").empty());
  CHECK(wrong_in("nodes", "#include \"graph/registry.h\"\n#include \"gltf/encoder.h\"\n").empty());
  CHECK(wrong_in("graph", "// #include \"nodes/all.h\"\nint include = 1;\n").empty());
}

TEST_CASE("The faces see single headers of the lower layers and no others") {
  CHECK(wrong_in("server", "#include \"service/engine.h\"\n#include \"graph/problem.h\"\n").empty());
  CHECK(wrong_in("server", "#include \"graph/document.h\"\n").size() == 1);
  CHECK(wrong_in("server", "#include \"algebra/kernels.h\"\n").size() == 1);
  CHECK(wrong_in("cli", "#include \"algebra/kernels.h\"\n").empty());
  CHECK(wrong_in("cli", "#include \"algebra/versor.h\"\n").size() == 1);
}

TEST_CASE("A path that does not start at the root is found") {
  CHECK(wrong_in("geometry", "#include \"mesh.h\"\n").size() == 1);
}

}  // namespace
