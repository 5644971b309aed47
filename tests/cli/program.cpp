#include "tests/cli/program.h"

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dini::support {
namespace {

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// In the child: a file in place of a standard stream.
void redirect(const std::string& path, int flags, int stream) {
  const int descriptor = ::open(path.c_str(), flags, 0600);
  if (descriptor < 0 || ::dup2(descriptor, stream) < 0) ::_exit(127);
}

}  // namespace

Program::Program(const std::vector<std::string>& words, const std::string& input) {
  std::string pattern = (std::filesystem::temp_directory_path() / "dini-run-XXXXXX").string();
  folder_ = ::mkdtemp(pattern.data());
  std::ofstream(folder_ + "/in", std::ios::binary) << input;
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  process_ = ::fork();
  if (process_ != 0) return;
  redirect(folder_ + "/in", O_RDONLY, 0);
  redirect(folder_ + "/out", O_WRONLY | O_CREAT, 1);
  redirect(folder_ + "/err", O_WRONLY | O_CREAT, 2);
  ::execv(arguments.front(), arguments.data());
  ::_exit(127);
}

Program::~Program() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  std::filesystem::remove_all(folder_);
}

void Program::signal(int number) const { ::kill(process_, number); }

Outcome Program::wait() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .out = contents(folder_ + "/out"),
          .err = contents(folder_ + "/err")};
}

std::string dini_path() {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "dini_toy").string();
}

Outcome run_dini(const std::vector<std::string>& words, const std::string& input) {
  std::vector<std::string> all = {dini_path()};
  all.insert(all.end(), words.begin(), words.end());
  return Program(all, input).wait();
}

}  // namespace dini::support
