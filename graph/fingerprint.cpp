#include "graph/fingerprint.h"

#include <map>

namespace dini {

namespace {

/// Numbers axes by first appearance, so that a fingerprint knows how they pair up without knowing their names.
class AxisNumbers {
 public:
  void write(DigestBuilder& digest, const Axes& axes) {
    digest.integer(axes.size());
    for (const Axis& axis : axes) {
      const auto known = numbers_.emplace(axis.name, numbers_.size()).first;
      digest.integer(known->second).integer(axis.size).integer(axis.closed ? 1 : 0);
    }
  }

 private:
  std::map<std::string, std::size_t> numbers_;
};

void write_literal(DigestBuilder& digest, const Argument& argument) {
  if (const auto* literal = std::get_if<Literal>(&argument)) {
    digest.text("literal").integer(literal->index());
    if (const auto* integer = std::get_if<std::int64_t>(literal)) digest.integer(static_cast<std::uint64_t>(*integer));
    if (const auto* flag = std::get_if<bool>(literal)) digest.integer(*flag ? 1 : 0);
    if (const auto* text = std::get_if<std::string>(literal)) digest.text(*text);
    if (const auto* file = std::get_if<SharedAssetFile>(literal)) digest.digest((*file)->sha256);
    if (const auto* color = std::get_if<Color>(literal)) {
      for (const double component : *color) digest.number(component);
    }
    return;
  }
  const auto& value = std::get<Value>(argument);
  digest.text(name(value.type()));
  std::visit(
      [&]<class T>(const std::shared_ptr<const Column<T>>& column) {
        if constexpr (Column<T>::numeric) {
          for (std::size_t k = 0; k < Column<T>::width; ++k) digest.number(*column->component(k));
        }
      },
      value.column);
}

}  // namespace

Digest fingerprint(const PlannedNode& node, const Plan& plan) {
  const NodeType& type = *node.type;
  DigestBuilder digest;
  digest.text(type.id).integer(static_cast<std::uint64_t>(type.version));
  digest.integer(node.overload->number);
  if (type.makes_meshes_by_quality()) {
    digest.integer(node.triangle_budget);  // a mesh that a draft need not thin is the final one
  } else if (type.depends_on_quality) {
    digest.text(plan.detail.quality == Quality::draft ? "draft" : "final");
  }
  AxisNumbers axes;
  for (std::size_t port = 0; port < node.inputs.size(); ++port) {
    if (type.inputs[port].spec.is_axis_name) continue;
    const PlannedInput& input = node.inputs[port];
    digest.integer(input.items.size());
    for (const PlannedItem& item : input.items) {
      if (const auto* source = std::get_if<Source>(&item.from)) {
        digest.text("wire").digest(plan.nodes[source->node].fingerprint).integer(source->output);
        axes.write(digest, item.shape.axes);
        if (type.names_parts) digest.text(item.origin.part);
      } else {
        write_literal(digest, std::get<Argument>(item.from));
      }
    }
    axes.write(digest, input.list_axis ? Axes{*input.list_axis} : Axes{});
  }
  axes.write(digest, node.consumed);
  axes.write(digest, node.lifted);
  for (const Axes& made : node.made) axes.write(digest, made);
  return digest.finish();
}

}  // namespace dini
