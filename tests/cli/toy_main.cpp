// The real commands over the toy engine, so that the tests decide what evaluation does.

#include "cli/program.h"
#include "tests/support/toy_engine.h"

int main(int count, char** words) {
  return dini::cli::run_program(
      count, words, [](const dini::Limits& limits) { return std::make_unique<dini::toy::ToyEngine>(limits); });
}
