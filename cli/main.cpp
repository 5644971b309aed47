#include "cli/program.h"

int main(int count, char** words) { return dini::cli::run_program(count, words, dini::make_engine); }
