#include "cli/layout.h"

#include <algorithm>
#include <span>
#include <vector>

#include "cli/json_text.h"

namespace dini::cli {
namespace {

/// Characters of a line; the longest node of the examples has a little less.
constexpr std::size_t widest_line = 500;

using Kind = TextValue::Kind;

bool is_flat(const TextValue& value) {
  return std::ranges::all_of(value.members, [](const TextMember& member) { return member.value.members.empty(); });
}

class Layout {
 public:
  explicit Layout(std::string_view text) : text_(text) {}

  std::string document(const TextValue& root) {
    static constexpr std::string_view order[] = {"$schema", "format", "meta", "parameters", "groups", "nodes", "ui"};
    std::vector<std::string> lines;
    for (const TextMember* member : sorted(root, order)) {
      // What the page remembers has by node where it stands: a line for each, so that edits of two people merge.
      const int split = member->name == "ui" ? 2 : 1;
      lines.push_back(name(*member) + (member->name == "groups"
                                           ? groups(member->value)
                                           : value(member->value, 2, split, member->name == "nodes")));
    }
    return block(lines, '{', 0) + "\n";
  }

 private:
  std::string_view written(const TextValue& value) const { return text_.substr(value.begin, value.end - value.begin); }

  /// `"name": ` of a member of an object.
  std::string name(const TextMember& member) const {
    const std::string_view from = text_.substr(member.begin, member.value.begin - member.begin);
    return std::string(from.substr(0, from.rfind('"') + 1)) + ": ";
  }

  static std::vector<const TextMember*> sorted(const TextValue& owner, std::span<const std::string_view> order) {
    std::vector<const TextMember*> members;
    for (const TextMember& member : owner.members) members.push_back(&member);
    const auto rank = [&](const TextMember* member) { return std::ranges::find(order, member->name) - order.begin(); };
    if (owner.kind == Kind::object) std::ranges::stable_sort(members, {}, rank);
    return members;
  }

  static std::vector<const TextMember*> members_of(const TextValue& owner, bool is_node) {
    static constexpr std::string_view order[] = {"type", "inputs", "bypass"};
    return sorted(owner, is_node ? std::span<const std::string_view>(order) : std::span<const std::string_view>());
  }

  std::string in_one_line(const TextValue& value, bool is_node) const {
    if (value.kind == Kind::scalar) return std::string(written(value));
    std::string line;
    for (const TextMember* member : members_of(value, is_node)) {
      if (!line.empty()) line += ", ";
      if (value.kind == Kind::object) line += name(*member);
      line += in_one_line(member->value, false);
    }
    return value.kind == Kind::object ? "{" + line + "}" : "[" + line + "]";
  }

  static std::string block(const std::vector<std::string>& lines, char bracket, std::size_t indent) {
    std::string text(1, bracket);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      text += (i > 0 ? ",\n" : "\n") + std::string(indent + 2, ' ') + lines[i];
    }
    return text + "\n" + std::string(indent, ' ') + (bracket == '{' ? '}' : ']');
  }

  /// Each group with a line for each of its members, and one for each of its nodes.
  std::string groups(const TextValue& shown) const {
    static constexpr std::string_view order[] = {"label", "description", "inputs", "outputs", "nodes"};
    constexpr std::size_t indent = 2;
    if (shown.kind != Kind::object || shown.members.empty()) return value(shown, indent, 1, false);
    std::vector<std::string> lines;
    for (const TextMember& group : shown.members) {
      std::vector<std::string> members;
      for (const TextMember* member : sorted(group.value, order)) {
        const bool is_nodes = member->name == "nodes";
        members.push_back(name(*member) + value(member->value, indent + 4, is_nodes ? 1 : 0, is_nodes));
      }
      const bool is_block = group.value.kind == Kind::object && !members.empty();
      lines.push_back(name(group) +
                      (is_block ? block(members, '{', indent + 2) : value(group.value, indent + 2, 0, false)));
    }
    return block(lines, '{', indent);
  }

  /// A value whose line begins with so many spaces. It is split for `split` levels, and where it does not fit.
  std::string value(const TextValue& shown, std::size_t indent, int split, bool holds_nodes,
                    bool is_node = false) const {
    const bool has_names = shown.kind == Kind::object;
    if (shown.members.empty()) return has_names ? "{}" : in_one_line(shown, false);
    if (split <= 0 || !has_names) {
      std::string line = in_one_line(shown, is_node);
      if (indent + line.size() <= widest_line || (!has_names && is_flat(shown))) return line;
    }
    std::vector<std::string> lines;
    for (const TextMember* member : members_of(shown, is_node)) {
      lines.push_back((has_names ? name(*member) : "") +
                      value(member->value, indent + 2, split - 1, false, holds_nodes));
    }
    return block(lines, has_names ? '{' : '[', indent);
  }

  const std::string_view text_;
};

}  // namespace

std::string canonical_layout(std::string_view text) {
  const TextValue root = read_json_text(text);
  return Layout(text).document(root);
}

}  // namespace dini::cli
