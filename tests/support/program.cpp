#include "tests/support/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/support/temporary_folder.h"

namespace cuesta {
namespace {

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// Only calls that are allowed between fork and exec.
[[noreturn]] void become(const char* program, char* const* arguments, const char* folder, const char* out,
                         const char* err) {
  const int none = open("/dev/null", O_RDONLY);
  const int out_file = open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err_file = open(err, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (chdir(folder) == 0 && dup2(none, 0) == 0 && dup2(out_file, 1) == 1 && dup2(err_file, 2) == 2) {
    execv(program, arguments);
  }
  _exit(127);
}

}  // namespace

ProgramResult run_program(const std::string& program, const std::vector<std::string>& arguments,
                          const std::string& folder, const Interrupt* interrupt) {
  const TemporaryFolder logs;
  const std::string out = logs.path("out"), err = logs.path("err");
  std::vector<char*> words = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);

  const pid_t child = fork();
  if (child == 0) become(program.c_str(), words.data(), folder.c_str(), out.c_str(), err.c_str());
  int status = 0;
  bool ended = false;
  if (interrupt) {
    while (!ended && contents(err).find(interrupt->after_text) == std::string::npos) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      ended = waitpid(child, &status, WNOHANG) == child;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(interrupt->milliseconds));
    if (!ended) kill(child, interrupt->signal);
  }
  if (!ended) waitpid(child, &status, 0);
  ProgramResult result;
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = contents(out);
  result.err = contents(err);
  return result;
}

}  // namespace cuesta
