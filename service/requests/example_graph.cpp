#include "service/requests/description.h"

namespace dini {

const Json& example_graph() {
  static const Json graph = Json::parse(R"({
    "format": 1,
    "parameters": {"reach": {"type": "number", "default": 1, "min": 0, "max": 4}},
    "nodes": {
      "ring": {"type": "circle", "inputs": {"radius": 1}},
      "pair": {"type": "point_pair", "inputs": {"position": [0, 0, 1.5], "direction": [0, 0, 1]}},
      "amounts": {"type": "range", "inputs": {"from": 0, "to": {"parameter": "reach"}, "count": 8}},
      "boosted": {
        "type": "boost",
        "inputs": {"shape": {"from": "ring"}, "generator": {"from": "pair"}, "amount": {"from": "amounts"}}
      },
      "skin": {"type": "surface", "inputs": {"shape": {"from": "boosted"}, "segments": 16}},
      "out": {"type": "export", "inputs": {"model": {"from": "skin"}}}
    }
  })");
  return graph;
}

}  // namespace dini
