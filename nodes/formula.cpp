#include "nodes/formula.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <muParserBase.h>
#include <string_view>

#include "algebra/elementary.h"

namespace dini {

namespace {

double add(double a, double b) { return a + b; }
double subtract(double a, double b) { return a - b; }
double multiply(double a, double b) { return a * b; }
double divide(double a, double b) { return a / b; }
double less(double a, double b) { return a < b ? 1 : 0; }
double less_equal(double a, double b) { return a <= b ? 1 : 0; }
double greater(double a, double b) { return a > b ? 1 : 0; }
double greater_equal(double a, double b) { return a >= b ? 1 : 0; }
double equal(double a, double b) { return a == b ? 1 : 0; }
double not_equal(double a, double b) { return a == b ? 0 : 1; }
double both(double a, double b) { return a != 0 && b != 0 ? 1 : 0; }
double either(double a, double b) { return a != 0 || b != 0 ? 1 : 0; }
double negate(double a) { return -a; }
double keep(double a) { return a; }
double absolute(double a) { return std::abs(a); }
double sign(double a) { return a > 0 ? 1 : a < 0 ? -1 : 0; }
double minimum(double a, double b) { return b < a ? b : a; }
double maximum(double a, double b) { return a < b ? b : a; }
double modulo(double a, double b) { return a - b * std::floor(a / b); }
double square_root(double a) { return std::sqrt(a); }
double floor_of(double a) { return std::floor(a); }
double ceil_of(double a) { return std::ceil(a); }
double round_of(double a) { return std::round(a); }

struct OneArgument {
  const char* name;
  double (*function)(double);
};
struct TwoArguments {
  const char* name;
  double (*function)(double, double);
};

constexpr OneArgument one_argument[] = {{"sin", elementary::sin},
                                        {"cos", elementary::cos},
                                        {"tan", elementary::tan},
                                        {"asin", elementary::asin},
                                        {"acos", elementary::acos},
                                        {"atan", elementary::atan},
                                        {"sinh", elementary::sinh},
                                        {"cosh", elementary::cosh},
                                        {"tanh", elementary::tanh},
                                        {"asinh", elementary::asinh},
                                        {"acosh", elementary::acosh},
                                        {"atanh", elementary::atanh},
                                        {"exp", elementary::exp},
                                        {"ln", elementary::log},
                                        {"log", elementary::log},
                                        {"log2", elementary::log2},
                                        {"log10", elementary::log10},
                                        {"sqrt", square_root},
                                        {"cbrt", elementary::cbrt},
                                        {"abs", absolute},
                                        {"sign", sign},
                                        {"floor", floor_of},
                                        {"ceil", ceil_of},
                                        {"round", round_of}};

constexpr TwoArguments two_arguments[] = {{"atan2", elementary::atan2},
                                          {"pow", elementary::pow},
                                          {"hypot", elementary::hypot},
                                          {"min", minimum},
                                          {"max", maximum},
                                          {"mod", modulo}};

/// Reads a number for muParser, independent of the locale.
int read_number(const char* text, int* position, double* value) {
  const std::string_view rest(text);
  if (rest.empty() || (rest[0] != '.' && (rest[0] < '0' || rest[0] > '9'))) return 0;
  const std::from_chars_result read = std::from_chars(rest.data(), rest.data() + rest.size(), *value);
  if (read.ec != std::errc{}) return 0;
  *position += static_cast<int>(read.ptr - rest.data());
  return 1;
}

/// A parser without any built-in function or operator; `?:` is the only thing muParser computes by itself.
class PureParser : public mu::ParserBase {
 public:
  PureParser() {
    EnableBuiltInOprt(false);
    AddValIdent(read_number);
    InitCharSets();
    InitFun();
    InitConst();
    InitOprt();
  }

 private:
  void InitCharSets() override {
    DefineNameChars("0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
    DefineOprtChars("+-*/^<>=!&|?:");
    DefineInfixOprtChars("+-");
  }
  void InitFun() override {
    for (const OneArgument& entry : one_argument) DefineFun(entry.name, entry.function);
    for (const TwoArguments& entry : two_arguments) DefineFun(entry.name, entry.function);
  }
  void InitConst() override {
    DefineConst("pi", 3.14159265358979323846);
    DefineConst("e", 2.71828182845904523536);
  }
  void InitOprt() override {
    DefineInfixOprt("-", negate, mu::prINFIX);
    DefineInfixOprt("+", keep, mu::prINFIX);
    DefineOprt("+", add, mu::prADD_SUB);
    DefineOprt("-", subtract, mu::prADD_SUB);
    DefineOprt("*", multiply, mu::prMUL_DIV);
    DefineOprt("/", divide, mu::prMUL_DIV);
    DefineOprt("^", elementary::pow, mu::prPOW, mu::oaRIGHT);
    DefineOprt("<", less, mu::prCMP);
    DefineOprt("<=", less_equal, mu::prCMP);
    DefineOprt(">", greater, mu::prCMP);
    DefineOprt(">=", greater_equal, mu::prCMP);
    DefineOprt("==", equal, mu::prCMP);
    DefineOprt("!=", not_equal, mu::prCMP);
    DefineOprt("&&", both, mu::prLAND);
    DefineOprt("||", either, mu::prLOR);
  }
};

/// muParser's sentence without the position, which it counts from 0, and without its capital and full stop.
std::string reason_of(const mu::ParserError& error) {
  std::string text = mu::ParserErrorMsg::Instance()[static_cast<unsigned>(error.GetCode())];
  for (const std::string_view position : {" found at position $POS$", " at expression position $POS$",
                                          " starting at position $POS$", " at position $POS$", " (position: $POS$)"}) {
    if (const std::size_t at = text.find(position); at != std::string::npos) text.erase(at, position.size());
  }
  constexpr std::string_view token_mark = "$TOK$";
  if (const std::size_t at = text.find(token_mark); at != std::string::npos) {
    std::string token = error.GetToken();
    token.erase(token.find_last_not_of(' ') + 1);
    text.replace(at, token_mark.size(), token);
  }
  text.erase(text.find_last_not_of(".!") + 1);
  if (!text.empty()) text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
  return text;
}

/// The place of a byte in a UTF-8 text as people count: characters, from 1. muParser can point past the end, and points
/// nowhere (-1) when something is missing there.
std::size_t character_at(const std::string& text, int byte) {
  const auto end = byte < 0 ? text.size() : std::min(static_cast<std::size_t>(byte), text.size());
  const auto starts = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; };
  return static_cast<std::size_t>(
             std::count_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), starts)) +
         1;
}

}  // namespace

struct Formula::Parser {
  PureParser parser;
  std::array<double, 4> variables{};
};

Formula::Formula(std::unique_ptr<Parser> parser) : parser_(std::move(parser)) {}
Formula::Formula(Formula&&) noexcept = default;
Formula::~Formula() = default;

std::optional<Formula> Formula::compile(const std::string& text, std::string& wrong) {
  constexpr std::size_t longest = 1000;
  if (text.empty() || text.size() > longest) {
    wrong = text.empty() ? "the formula is empty" : "the formula is longer than 1000 characters";
    return std::nullopt;
  }
  auto parser = std::make_unique<Parser>();
  try {
    constexpr std::array names = {"x", "y", "z", "w"};
    for (std::size_t k = 0; k < names.size(); ++k) parser->parser.DefineVar(names[k], &parser->variables[k]);
    parser->parser.SetExpr(text);
    parser->parser.Eval();
    if (parser->parser.GetNumResults() != 1) {
      wrong = "the formula must have one value, not " + std::to_string(parser->parser.GetNumResults());
      return std::nullopt;
    }
  } catch (const mu::ParserError& error) {
    wrong = "the formula cannot be read at character " + std::to_string(character_at(text, error.GetPos())) + ": " +
            reason_of(error);
    return std::nullopt;
  }
  return Formula(std::move(parser));
}

double Formula::evaluate(const std::array<double, 4>& variables) const {
  parser_->variables = variables;
  try {
    return parser_->parser.Eval();
  } catch (const mu::ParserError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

std::optional<std::string> Formula::fault(const std::string& text) {
  std::string wrong;
  return compile(text, wrong) ? std::nullopt : std::optional(wrong);
}

std::string Formula::function_names() {
  std::string names;
  for (const OneArgument& entry : one_argument) names += std::string(names.empty() ? "" : " ") + entry.name;
  for (const TwoArguments& entry : two_arguments) names += std::string(" ") + entry.name;
  return names;
}

}  // namespace dini
