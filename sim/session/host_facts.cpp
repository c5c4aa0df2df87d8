#include "sim/session/host_facts.h"

#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>

namespace cuesta {
namespace {

/// What stands behind the colon of the first line that begins with `key`; the whole line where it has none.
std::string first_line_with(const char* file, const std::string& key) {
  std::ifstream text(file);
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with(key)) continue;
    const size_t colon = line.find(':');
    return colon == std::string::npos ? line : line.substr(std::min(colon + 2, line.size()));
  }
  return "unknown";
}

}  // namespace

std::string host_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

std::string processor_name() { return first_line_with("/proc/cpuinfo", "model name"); }

std::string load_average() { return first_line_with("/proc/loadavg", ""); }

std::string time_now(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[64];
  return {text, std::strftime(text, sizeof text, format, &parts)};
}

}  // namespace cuesta
