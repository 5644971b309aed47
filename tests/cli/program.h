#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace dini::support {

/// What a finished program left behind.
struct Outcome {
  int code = -1;  ///< the exit code, or -1 when a signal ended it
  std::string out;
  std::string err;
};

/// A program running beside the test, without a shell in between.
class Program {
 public:
  explicit Program(const std::vector<std::string>& words, const std::string& input = "");
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void signal(int number) const;
  Outcome wait();

 private:
  pid_t process_ = -1;
  std::string folder_;  ///< of the files that stand for its streams
};

/// Runs the command line over the toy engine to its end.
Outcome run_dini(const std::vector<std::string>& words, const std::string& input = "");

/// Where that program is.
std::string dini_path();

}  // namespace dini::support
