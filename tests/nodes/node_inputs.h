#pragma once

// Inputs for any node of the catalogue, found from its declaration alone: which types its ports take, whether it sees
// whole families of them, and what is required.

#include <optional>
#include <string>

#include "tests/support/catalogue.h"

namespace dini::support {

/// One function of one node type.
struct Subject {
  const NodeType* type;
  const Overload* overload;

  std::string name() const;
};

/// Every function of every node type.
std::vector<Subject> all_subjects();

/// Every fourth of them, from the first, second, third or last on: where all are minutes of work, tests take a quarter.
std::vector<Subject> quarter_of_subjects(std::size_t first);

/// The number that every wired source is made from.
constexpr double usual_drive = 0.35;

/// How a subject is wired up.
struct Wiring {
  /// Also wires inputs that have a default or may be left out; else only what is required.
  bool everything = false;
  /// The port whose source is made from `drive` instead of the usual number; none when empty.
  std::string driven = {};
  /// A number, or a list of numbers that runs over the axis "extra"; or {"count": n} for n numbers along that axis.
  Json drive = usual_drive;
  /// How many values there are along the axes that the subject consumes together; some when 0.
  std::size_t consumed = 0;
  /// About how many vertices the meshes have that it is given; some when 0.
  std::size_t vertices = 0;
  /// Literals that replace those of the card, by port.
  Json literals = Json::object();
};

/// A document's nodes: the subject as the node "subject" and, before it, a source for every wired port.
Json wired_nodes(const Subject& subject, const Wiring& wiring);

/// Literals that name the axes to consume, so that one to lift over is left.
Json consumed_names(const Subject& subject);

/// True for a port that takes links and so can run over an axis of its own.
bool can_be_lifted(const Subject& subject, std::size_t port);

/// A literal other than the default that the port accepts; nothing for ports without literals.
std::optional<Json> other_literal(const InputPort& port);

/// True when two values are the same bit by bit, axes aside.
bool same_content(const AnyColumn& a, const AnyColumn& b);

/// True when `size` values of `whole` from `begin` are those of `part`, bit by bit.
bool same_content(const AnyColumn& whole, std::size_t begin, std::size_t size, const AnyColumn& part);

}  // namespace dini::support
