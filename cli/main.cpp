#include "cli/program.h"

int main(int count, char** words) {
  return dini::cli::run_program(count, words, [](const dini::Limits& limits) { return dini::make_engine(limits); });
}
