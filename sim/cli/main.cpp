#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "sim/cli/command_line.h"
#include "sim/cli/progress.h"

namespace {

int fail(cuesta::ExitCode code, const char* sentence) {
  std::cout.flush();
  std::fprintf(stderr, "cuesta: %s\n", sentence);
  return static_cast<int>(code);
}

}  // namespace

/// Every way out of the program ends here: a documented exit code and one sentence.
int main(int count, char** arguments) {
  using cuesta::ExitCode;
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is a write that fails
  cuesta::install_stop_handler();
  try {
    const int code = cuesta::run_command_line(count, arguments);
    std::cout.flush();
    return code;
  } catch (const cuesta::Error& error) {
    return fail(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::kResource,
                "memory is exhausted; a smaller map, fewer rays or fewer machines need less.");
  } catch (const std::exception& error) {
    return fail(ExitCode::kInternal, (std::string("internal error: ") + error.what()).c_str());
  } catch (...) {
    return fail(ExitCode::kInternal, "internal error of an unknown kind.");
  }
}
