#include "cli/json_text.h"

#include <algorithm>

#include "service/engine.h"

namespace dini::cli {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

class TextReader {
 public:
  explicit TextReader(std::string_view text) : text_(text) {
    if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
  }

  /// Recursion is as deep as the text, which its strict reader bounds.
  TextValue value() {
    skip_space();
    TextValue read{.begin = at_};
    switch (text_[at_]) {
      case '{':
        read.kind = TextValue::Kind::object;
        break;
      case '[':
        read.kind = TextValue::Kind::array;
        break;
      case '"':
        skip_string();
        break;
      default:
        at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
    }
    if (read.kind != TextValue::Kind::scalar) read_members(read);
    read.end = at_;
    return read;
  }

 private:
  void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  void skip_string() {
    for (++at_; text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    ++at_;
  }

  void read_members(TextValue& owner) {
    ++at_;  // the opening bracket
    skip_space();
    while (text_[at_] != '}' && text_[at_] != ']') {
      TextMember member{.begin = at_};
      if (owner.kind == TextValue::Kind::object) {
        skip_string();
        member.name = Json::parse(text_.substr(member.begin, at_ - member.begin)).get<std::string>();
        skip_space();
        ++at_;  // the colon
      }
      member.value = value();
      owner.members.push_back(std::move(member));
      skip_space();
      if (text_[at_] == ',') ++at_;
      skip_space();
    }
    ++at_;
  }

  const std::string_view text_;
  std::size_t at_ = 0;
};

std::string unescaped(std::string_view token) {
  std::string name;
  for (std::size_t i = 0; i < token.size(); ++i) {
    if (token[i] != '~' || i + 1 == token.size()) {
      name += token[i];
      continue;
    }
    name += token[++i] == '1' ? '/' : '~';
  }
  return name;
}

const TextMember* member_of(const TextValue& owner, std::string_view token) {
  const std::string name = unescaped(token);
  for (std::size_t i = 0; i < owner.members.size(); ++i) {
    const bool meant = owner.kind == TextValue::Kind::array ? std::to_string(i) == name : owner.members[i].name == name;
    if (meant) return &owner.members[i];
  }
  return nullptr;
}

}  // namespace

TextValue read_json_text(std::string_view text) { return TextReader(text).value(); }

std::size_t offset_of(const TextValue& root, std::string_view pointer) {
  const TextValue* value = &root;
  std::size_t offset = root.begin;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::size_t end = std::min(pointer.find('/'), pointer.size());
    const TextMember* member = member_of(*value, pointer.substr(0, end));
    if (member == nullptr) break;
    offset = member->begin;
    value = &member->value;
    pointer.remove_prefix(end);
  }
  return offset;
}

TextPlace place_at(std::string_view text, std::size_t offset) {
  if (text.starts_with(byte_order_mark) && offset >= byte_order_mark.size()) {
    text.remove_prefix(byte_order_mark.size());
    offset -= byte_order_mark.size();
  }
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_start = before.rfind('\n') + 1;  // 0 in the first line
  const auto is_first_byte = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  const std::string_view line = before.substr(line_start);
  return {.line = 1 + static_cast<std::size_t>(std::ranges::count(before, '\n')),
          .column = 1 + static_cast<std::size_t>(std::ranges::count_if(line, is_first_byte))};
}

}  // namespace dini::cli
