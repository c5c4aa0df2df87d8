#include "sim/session/result_files.h"

#include <cstdio>
#include <filesystem>

#include "reports/image_write.h"
#include "reports/write_result.h"
#include "sim/session/host_facts.h"

namespace cuesta {
namespace {

namespace fs = std::filesystem;

constexpr size_t kLongestName = 80;

/// Leaves of a text what every file system takes in a name.
std::string fit_for_a_file(std::string text) {
  for (char& c : text) {
    const bool fits =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    if (!fits) c = '-';
  }
  return text.substr(0, kLongestName);
}

void write_configurations(const RunRequest& wanted, ResultFolder& folder) {
  const bool with_time = wanted.fidelity != Fidelity::kFunctional;
  for (const ResolvedArchitecture& machine : wanted.machines) {
    const bool alone = wanted.machines.size() == 1;
    const std::string name = alone ? "" : "." + fit_for_a_file(machine.architecture.name);
    folder.write("config.resolved" + name + ".toml", machine.toml(with_time));
  }
}

}  // namespace

ResultFolder open_result_folder(const std::string& name, const std::string& stem, bool overwrite) {
  if (!name.empty()) return ResultFolder::create(name, overwrite);
  for (int number = 1;; ++number) {
    char digits[16];
    std::snprintf(digits, sizeof digits, "-%03d", number);
    const fs::path path = fs::path("results") / (fit_for_a_file(stem) + digits);
    std::error_code ignored;
    if (fs::symlink_status(path, ignored).type() != fs::file_type::not_found) continue;
    return ResultFolder::create(path, false);
  }
}

Completion finish_result(const RunRequest& wanted, std::chrono::steady_clock::time_point start,
                         Result& result, ResultFolder& folder) {
  Completion done{0, planned_runs(wanted)};
  for (const RunEntry& run : result.runs) done.whole += !run.partial();
  if (result.runs.empty()) {
    throw Error(ExitCode::kIncomplete, "Stopped before the first run began; nothing is kept.");
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  char wall[32];
  std::snprintf(wall, sizeof wall, "%.3f", seconds.count());
  ManifestInfo::Pairs& environment = result.manifest.environment;
  environment.emplace_back("ended", time_now(kTimeOfDay));
  environment.emplace_back("wall_seconds", wall);
  if (!done.complete()) {
    environment.emplace_back(
        "stopped", std::to_string(done.whole) + " of " + std::to_string(done.planned) + " runs are whole");
  }
  write_configurations(wanted, folder);
  write_result(result, folder);
  write_planes(result, folder);
  folder.commit(done.complete());
  return done;
}

}  // namespace cuesta
