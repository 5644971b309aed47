#include "graph/order.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

using namespace dini;

namespace {

/// Nodes n0, n1 .. with up to four links each, some of them twice, some to nodes that do not exist.
Document random_document(std::mt19937& random, std::size_t count, bool with_cycles) {
  Document document;
  std::vector<std::size_t> rank(count);
  for (std::size_t i = 0; i < count; ++i) rank[i] = i;
  std::shuffle(rank.begin(), rank.end(), random);
  const auto any = [&](std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random); };
  for (std::size_t i = 0; i < count; ++i) {
    NodeEntry& node = document.nodes["n" + std::to_string(i)];
    for (std::size_t k = any(4); k > 0; --k) {
      const std::size_t source = any(count + 1);
      if (!with_cycles && source < count && rank[source] >= rank[i]) continue;
      InputEntry& input = node.inputs["in" + std::to_string(any(2))];
      for (std::size_t times = 1 + any(2); times > 0; --times) {
        input.items.push_back(Link{"n" + std::to_string(source), ""});
      }
    }
  }
  return document;
}

bool links_to(const Document& document, const std::string& node, const std::string& source) {
  for (const std::string* each : sources_of(document.nodes.at(node))) {
    if (*each == source) return true;
  }
  return false;
}

/// Again and again the first node by id whose sources have all been taken.
std::vector<std::string> slow_order(const Document& document) {
  std::vector<std::string> order;
  const auto is_taken = [&](const std::string& id) { return std::ranges::find(order, id) != order.end(); };
  for (bool found = true; found;) {
    found = false;
    for (const auto& [id, node] : document.nodes) {
      const auto sources = sources_of(node);
      const bool waits = std::ranges::any_of(
          sources, [&](const std::string* source) { return document.nodes.contains(*source) && !is_taken(*source); });
      if (is_taken(id) || waits) continue;
      order.push_back(id);
      found = true;
      break;
    }
  }
  return order;
}

}  // namespace

TEST_CASE("Each node stands after those it links to, and ties go by id") {
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    const Document document = random_document(random, 30, round % 2 == 0);
    const Order order = evaluation_order(document);
    CHECK(order.ids == slow_order(document));
    CHECK((order.ids.size() < document.nodes.size()) == !order.cycles.empty());
    for (const std::vector<std::string>& cycle : order.cycles) {
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        CHECK(links_to(document, cycle[(i + 1) % cycle.size()], cycle[i]));
      }
    }
  }
}

TEST_CASE("What targets need is what their links lead to") {
  std::mt19937 random(5);
  for (int round = 0; round < 100; ++round) {
    const Document document = random_document(random, 30, round % 2 == 0);
    std::set<std::string> slow = {"n7", "n29"};
    for (bool grows = true; grows;) {
      grows = false;
      for (const std::string& id : std::set(slow)) {
        for (const std::string* source : sources_of(document.nodes.at(id))) {
          grows = (document.nodes.contains(*source) && slow.insert(*source).second) || grows;
        }
      }
    }
    CHECK(needed_for(document, {"n29", "nowhere", "n7", "n7"}) == slow);
  }
}
