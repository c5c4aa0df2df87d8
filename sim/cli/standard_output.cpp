#include "sim/cli/standard_output.h"

#include <poll.h>
#include <unistd.h>

#include <cstdio>

#include "models/common/error.h"

namespace cuesta {

void flush_standard_output() {
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && std::ferror(stdout) == 0) return;
  pollfd output = {STDOUT_FILENO, POLLOUT, 0};
  const bool reader_has_gone = poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
  if (!reader_has_gone) throw Error(ExitCode::kResource, "Standard output cannot be written.");
}

}  // namespace cuesta
