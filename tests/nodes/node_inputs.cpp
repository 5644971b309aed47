#include "tests/nodes/node_inputs.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dini::support {

namespace {

/// Literals that no rule could guess from a card, with the reason.
const Json& literals_without_default() {
  static const Json literals = {{"expression.formula", "x + sin(y) * z - w / 3"},  // text in a language of its own
                                {"import.asset", "triangle"}};                     // a file
  return literals;
}

/// Adds nodes that make one family of a type out of the number at `drive`; over the axes "rows" and "columns" as the
/// rank says.
class Source {
 public:
  Source(Json& nodes, std::string prefix, std::string drive, int rank, const Wiring& wiring)
      : nodes_(nodes), prefix_(std::move(prefix)), drive_(from(drive)), rank_(rank), wiring_(wiring) {}

  std::string make(WireType type, bool axis_wanted) {
    switch (type) {
      case WireType::number:
        return rank_ == 0 ? add("number", "number", {{"value", drive_}}) : spread();
      case WireType::vector:
        return add("vector", "vector", {{"x", drive_}, {"y", along(0.4)}, {"z", 0.9}});
      case WireType::point:
        return point();
      case WireType::generator:
        return add(
            "generator", "point_pair",
            {{"position", {1.3, 0.2, -0.6}}, {"direction", from(make(WireType::vector, false))}, {"split", 0.1}});
      case WireType::circle:
        return axis_wanted ? line()
                           : add("circle", "circle",
                                 {{"center", {0.2, 0.1, 0.3}}, {"normal", {0.3, 0, 1}}, {"radius", spread_or_drive()}});
      case WireType::sphere:
        return add("sphere", "sphere",
                   {{"center", {0.2, -0.1, 0.4 * static_cast<double>(prefix_.size())}}, {"radius", drive_}});
      case WireType::mesh:
        return add("mesh", "sphere_mesh",
                   {{"center", {0.3, -0.2, 0.5}},
                    {"radius", drive_},
                    {"segments", wiring_.vertices == 0 ? 6 : side_of(wiring_.vertices)},
                    {"rings", wiring_.vertices == 0 ? 4 : side_of(wiring_.vertices)}});
      case WireType::field:
        add("ball", "sphere", {{"center", {0.2, -0.1, 0.4}}, {"radius", spread_or_drive()}});
        return add("field", "solid", {{"shape", from(prefix_ + "ball")}});
      default:
        FAIL("no source makes a " << name(type));
    }
    return {};
  }

 private:
  static std::size_t side_of(std::size_t whole) {
    return static_cast<std::size_t>(std::sqrt(static_cast<double>(whole)));
  }
  std::size_t along_one(std::size_t usual) const { return wiring_.consumed == 0 ? usual : wiring_.consumed; }

  std::string add(const std::string& id, const std::string& type, Json inputs) {
    nodes_[prefix_ + id] = support::make(type, std::move(inputs));
    return prefix_ + id;
  }

  /// Numbers over "rows", and "columns" where there are two axes, that depend on the drive.
  std::string spread() {
    add("rows", "range", {{"from", 0.25}, {"to", 1.5}, {"count", along_one(4)}, {"axis", "rows"}});
    if (rank_ < 2) {
      return add("spread", "expression", {{"formula", "x + y"}, {"x", from(prefix_ + "rows")}, {"y", drive_}});
    }
    add("columns", "range", {{"from", 0.1}, {"to", 0.4}, {"count", along_one(3)}, {"axis", "columns"}});
    return add(
        "spread", "expression",
        {{"formula", "x + y + x * z"}, {"x", from(prefix_ + "rows")}, {"y", drive_}, {"z", from(prefix_ + "columns")}});
  }
  Json along(double otherwise) { return rank_ == 0 ? Json(otherwise) : from(spread()); }
  Json spread_or_drive() { return rank_ == 0 ? drive_ : from(spread()); }

  std::string shift() { return add("shift", "vector", {{"x", drive_}, {"y", 0.1}, {"z", -0.2}}); }

  std::string point() {
    if (rank_ == 0) {
      add("place", "point", {{"position", {0.4 + mark(), -0.3, 0.6 + mark() * mark()}}});
    } else if (rank_ == 1) {
      add("ring", "circle", {{"normal", {0.2, 0.1, 1}}});
      add("place", "sample",
          {{"shape", from(prefix_ + "ring")}, {"count", along_one(4)}, {"closed", false}, {"axis", "rows"}});
    } else {
      add("place", "grid",
          {{"v_vector", {0, 1, 0.5}},
           {"count_u", wiring_.consumed == 0 ? 4 : side_of(wiring_.consumed)},
           {"count_v", wiring_.consumed == 0 ? 3 : side_of(wiring_.consumed)},
           {"axis_u", "rows"},
           {"axis_v", "columns"}});
    }
    return add("point", "translate", {{"shape", from(prefix_ + "place")}, {"vector", from(shift())}});
  }

  std::string line() {
    add("straight", "line",
        {{"point", {0.3, 0.4, 0}}, {"direction", {0.2 * static_cast<double>(prefix_.size()), 0.5, 1}}});
    return add("line", "translate", {{"shape", from(prefix_ + "straight")}, {"vector", from(shift())}});
  }

  /// A number that differs from port to port, for nodes that take no two equal points.
  double mark() const {
    int sum = 0;
    for (const char letter : prefix_) sum += letter;
    return 0.07 * (sum % 13);
  }

  Json& nodes_;
  std::string prefix_;
  Json drive_;
  int rank_;
  const Wiring& wiring_;
};

/// A circle that is not the shape itself is an axis to turn about, and so a line.
bool wants_line(const InputPort& port) { return port.name != "shape" && !port.spec.takes_several; }

void add_source(Json& nodes, const Subject& subject, std::size_t port, const Wiring& wiring) {
  const InputPort& card = subject.type->inputs[port];
  const std::string drive = "drive_" + card.name;
  const bool driven = wiring.driven == card.name;
  if (driven && wiring.drive.is_array()) {
    nodes[drive] = make("list", {{"items", wiring.drive}, {"axis", "extra"}});
  } else if (driven && wiring.drive.is_object()) {
    nodes[drive] =
        make("range", {{"from", usual_drive}, {"to", 0.9}, {"count", wiring.drive["count"]}, {"axis", "extra"}});
  } else {
    nodes[drive] = make("number", {{"value", driven ? wiring.drive : Json(usual_drive)}});
  }
  const int rank = subject.overload->inputs[port].consumed_axes;
  const std::string source =
      Source(nodes, card.name + "_", drive, rank, wiring).make(subject.overload->inputs[port].type, wants_line(card));
  nodes["subject"]["inputs"][card.name] = from(source);
}

bool same_mesh(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.normals == b.normals && a.uvs == b.uvs && a.colors == b.colors &&
         a.triangles == b.triangles && a.tile_ends == b.tile_ends && a.color == b.color && a.finish == b.finish;
}

bool same_field(const ScalarField& a, const ScalarField& b) {
  if (a.formula() != b.formula()) return false;
  for (int i = 0; i < 27; ++i) {
    const Vector place = 0.7 * Vector{i % 3 - 1.1, i / 3 % 3 - 0.9, i / 9 - 1.2};
    if (value_at(a, place) != value_at(b, place)) return false;
  }
  return true;
}

template <class T>
bool same_value(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, SharedMesh>) {
    return same_mesh(*a, *b);
  } else if constexpr (std::is_same_v<T, SharedFile>) {
    return *a->bytes == *b->bytes && a->media_type == b->media_type;
  } else if constexpr (std::is_same_v<T, SharedField>) {
    return same_field(*a, *b);
  } else {
    std::array<double, Components<T>::width> left, right;
    Components<T>::set(left.data(), 1, a);
    Components<T>::set(right.data(), 1, b);
    return std::equal(left.begin(), left.end(), right.begin(), [](double x, double y) {
      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
  }
}

}  // namespace

std::string Subject::name() const {
  return type->id + (overload->inputs.empty() ? "" : " of a " + std::string(dini::name(overload->inputs.front().type)));
}

std::vector<Subject> all_subjects() {
  std::vector<Subject> subjects;
  for (const auto& [id, type] : catalogue().types()) {
    for (const Overload& overload : type.overloads) subjects.push_back({&type, &overload});
  }
  return subjects;
}

std::vector<Subject> quarter_of_subjects(std::size_t first) {
  const std::vector<Subject> all = all_subjects();
  std::vector<Subject> quarter;
  for (std::size_t index = first; index < all.size(); index += 4) quarter.push_back(all[index]);
  return quarter;
}

Json wired_nodes(const Subject& subject, const Wiring& wiring) {
  Json nodes = {{"subject", make(subject.type->id)}};
  for (std::size_t port = 0; port < subject.type->inputs.size(); ++port) {
    const InputPort& card = subject.type->inputs[port];
    const auto known = literals_without_default().find(subject.type->id + "." + card.name);
    if (wiring.literals.contains(card.name)) {
      nodes["subject"]["inputs"][card.name] = wiring.literals[card.name];
    } else if (known != literals_without_default().end()) {
      nodes["subject"]["inputs"][card.name] = *known;
    } else if (card.required() || ((wiring.everything || wiring.driven == card.name) && can_be_lifted(subject, port))) {
      add_source(nodes, subject, port, wiring);
    }
  }
  return nodes;
}

Json consumed_names(const Subject& subject) {
  Json literals = Json::object();
  const std::vector<std::string> names = {"rows", "columns"};
  for (std::size_t k = 0; k < subject.overload->consumed_axes(); ++k) {
    literals[subject.type->over[k]] = names[k];
  }
  return literals;
}

bool can_be_lifted(const Subject& subject, std::size_t port) {
  return subject.overload->inputs[port].is_mixed() || !info(subject.overload->inputs[port].type).literal_only;
}

std::optional<Json> other_literal(const InputPort& port) {
  const Json& usual = port.spec.default_value;
  if (usual.is_null() && port.types.front() != WireType::text) return std::nullopt;
  switch (port.types.front()) {
    case WireType::number:
    case WireType::integer: {
      const Json next =
          usual.is_number_integer() ? Json(usual.get<std::int64_t>() + 1) : Json(usual.get<double>() + 0.5);
      if (!port.spec.maximum || next.get<double>() <= *port.spec.maximum) return next;
      return usual.is_number_integer() ? Json(usual.get<std::int64_t>() - 1) : Json(usual.get<double>() - 0.5);
    }
    case WireType::vector:
    case WireType::point:
      return Json{0.5, 0.25, 0.125};
    case WireType::color:
      return Json{0.5, 0.25, 0.125, 0.75};
    case WireType::boolean:
      return Json(!usual.get<bool>());
    case WireType::choice:
      return Json(port.choices.front() == usual ? port.choices.back() : port.choices.front());
    case WireType::text:
      return Json(port.names_file ? "square" : port.spec.text_fault_code == "invalid-links" ? "0-1 1-2" : "x * 2");
    default:
      return std::nullopt;
  }
}

bool same_content(const AnyColumn& whole, std::size_t begin, std::size_t size, const AnyColumn& part) {
  if (whole.index() != part.index()) return false;
  return std::visit(
      [&](const auto& column) {
        const auto& other = *std::get<std::remove_cvref_t<decltype(column)>>(part);
        if (other.size() != size || column->size() < begin + size) return false;
        for (std::size_t i = 0; i < size; ++i) {
          if (!same_value((*column)[begin + i], other[i])) return false;
        }
        return true;
      },
      whole);
}

bool same_content(const AnyColumn& a, const AnyColumn& b) {
  const std::size_t size = std::visit([](const auto& column) { return column->size(); }, b);
  return size == std::visit([](const auto& column) { return column->size(); }, a) && same_content(a, 0, size, b);
}

}  // namespace dini::support
