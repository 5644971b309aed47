#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace dini {

/// A formula over x, y, z, w. Parsed by muParser with our own operators and elementary functions in the place of the C
/// library's, so that it gives the same bits on every machine.
class Formula {
 public:
  /// Nothing when the text is no formula; `wrong` then says what and where.
  static std::optional<Formula> compile(const std::string& text, std::string& wrong);

  /// The value for x, y, z, w; NaN where the formula has none. Not for use from two threads at once.
  double evaluate(const std::array<double, 4>& variables) const;

  /// What is wrong with a text as a formula, or nothing.
  static std::optional<std::string> fault(const std::string& text);

  /// The names of the functions, for documentation.
  static std::string function_names();

  Formula(Formula&&) noexcept;
  ~Formula();

 private:
  struct Parser;
  explicit Formula(std::unique_ptr<Parser> parser);
  std::unique_ptr<Parser> parser_;
};

}  // namespace dini
