#include <chrono>
#include <fstream>
#include <iostream>

#include "graph/check.h"
#include "graph/evaluate.h"
#include "nodes/all.h"
#include "tests/memory/memory_meter.h"
#include "tests/support/documents.h"
using namespace dini;
using namespace dini::support;
int main(int argc, char** argv) {
  Registry r;
  add_all_nodes(r);
  for (int i = 1; i < argc; ++i) {
    Json j = Json::parse(std::ifstream(argv[i]));
    for (const auto& [name, nodes] : j.items()) {
      auto doc = read_document(document(nodes), Limits{});
      if (!doc) {
        std::cout << name << " bad\n";
        continue;
      }
      auto rep = check(r, *doc, {}, Quality::final, Limits{});
      for (auto& p : rep.problems) std::cout << name << " " << p.code << " " << p.detail << "\n";
      if (!rep.problems.empty()) continue;
      // one node after another, each measured alone
      Cache cache(std::size_t{64} << 30);
      Cancel cancel;
      for (std::size_t k = 0; k < rep.plan.nodes.size(); ++k) {
        const auto& n = rep.plan.nodes[k];
        restart_memory_meter();
        auto t = std::chrono::steady_clock::now();
        {
          auto e = evaluate(rep.plan, {k}, cache, cancel);
          double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - t).count();
          if (!e) {
            std::cout << name << " " << n.id << " " << e.problems()[0].detail << "\n";
            break;
          }
          std::size_t kept = 0;
          for (auto& c : e->runs.at(k).result->columns) kept += bytes(c);
          std::size_t samples = 0, verts = 0;
          for (auto& s : n.outputs) {
            samples += sample_count(s.axes);
            verts += s.vertices;
          }
          printf(
              "%-22s %-10s %-18s ms %9.2f  kept %8.2f MB peak %8.2f MB  samples %zu verts %zu  B/v %.0f ns/v %.1f  B/s "
              "%.0f ns/s %.1f\n",
              name.c_str(), n.id.c_str(), n.type->id.c_str(), ms, kept / 1e6, most_memory() / 1e6, samples, verts,
              verts ? double(most_memory() - kept) / verts : 0., verts ? ms * 1e6 / verts : 0.,
              samples ? double(most_memory() - kept) / samples : 0., samples ? ms * 1e6 / samples : 0.);
        }
      }
    }
  }
}
