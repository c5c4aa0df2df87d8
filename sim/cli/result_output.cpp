#include "sim/cli/result_output.h"

#include <cstdio>
#include <filesystem>

#include "models/common/build_info.h"
#include "models/common/digest.h"
#include "models/common/words.h"
#include "reports/image_write.h"
#include "reports/result_json.h"
#include "reports/table.h"
#include "reports/write_result.h"
#include "sim/cli/standard_output.h"
#include "sim/session/host_facts.h"

namespace cuesta {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTimeOfDay = "%Y-%m-%dT%H:%M:%SZ";

/// A file name's letters only.
std::string fit_for_a_file(std::string text) {
  for (char& c : text) {
    const bool fits =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    if (!fits) c = '-';
  }
  return text.substr(0, 80);
}

void write_configurations(const std::vector<ResolvedArchitecture>& machines, Fidelity fidelity,
                          ResultFolder& folder) {
  const bool with_time = fidelity != Fidelity::kFunctional;
  if (machines.size() == 1) {
    folder.write("config.resolved.toml", machines[0].toml(with_time));
    return;
  }
  for (const ResolvedArchitecture& machine : machines) {
    folder.write("config.resolved." + fit_for_a_file(machine.architecture.name) + ".toml",
                 machine.toml(with_time));
  }
}

}  // namespace

ResultFolder open_result_folder(const RunOptions& options, const std::string& stem) {
  if (!options.folder.empty()) return ResultFolder::create(options.folder, options.force);
  for (int number = 1;; ++number) {
    char digits[16];
    std::snprintf(digits, sizeof digits, "-%03d", number);
    const fs::path path = fs::path("results") / (fit_for_a_file(stem) + digits);
    std::error_code ignored;
    if (fs::symlink_status(path, ignored).type() != fs::file_type::not_found) continue;
    return ResultFolder::create(path, false);
  }
}

Result begin_result(const std::string& command, const Session& session) {
  Result result;
  result.command = command;
  const BuildInfo& build = build_info();
  ManifestInfo& manifest = result.manifest;
  manifest.version = build.version;
  manifest.commit = build.commit;
  manifest.compiler = build.compiler;
  manifest.flags = build.flags;
  for (const LinkedLibrary& library : build.libraries)
    manifest.libraries.emplace_back(library.name, library.version);
  manifest.environment = {
      {"command_line", session.command_line}, {"host", host_name()}, {"started", time_now(kTimeOfDay)}};
  return result;
}

void add_inputs(const Job& job, Result& result) {
  const auto add = [&](const Input& input) {
    for (const Input& known : result.inputs) {
      if (known.role == input.role && known.path == input.path) return;
    }
    result.inputs.push_back(input);
  };
  for (const Input& input : job.inputs) add(input);
  if (!job.scene.generated.kind.empty()) {
    result.manifest.seeds.emplace_back("heightmap of scene " + job.scene.name,
                                       std::to_string(job.scene.generated.seed));
  }
  if (!job.scene.ray_set.kind.empty()) {
    result.manifest.seeds.emplace_back("rays of scene " + job.scene.name,
                                       std::to_string(job.scene.ray_set.seed));
  }
}

void add_inputs(const std::vector<ResolvedArchitecture>& machines, Result& result) {
  for (const ResolvedArchitecture& machine : machines) {
    for (const std::string& file : machine.files)
      result.inputs.push_back({"architecture", file, sha256_of_file(file)});
  }
}

void add_preprocessing(const Session& session, const Measurer& measurer, Result& result) {
  constexpr double kLong = 1;
  for (const Measurer::Preprocessing& one : measurer.preprocessing()) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.3f", one.seconds);
    result.manifest.environment.emplace_back("preprocessing_seconds." + one.what, seconds);
    if (session.quiet || one.seconds < kLong) continue;
    std::fprintf(stderr, "The map that %s reads took %s s to make.\n", one.what.c_str(), seconds);
  }
}

void remark_inputs(const Session& session, const Job& job,
                   const std::vector<ResolvedArchitecture>& machines) {
  if (session.quiet) return;
  std::fprintf(stderr, "Scene %s: %zu rays, %d x %d pixels; heights: %s.\n", job.scene.name.c_str(),
               job.trace.rays.size(), job.trace.width, job.trace.height, job.heights_statement.c_str());
  for (const ResolvedArchitecture& machine : machines) {
    if (machine.unused.empty()) continue;
    const std::vector<std::string_view> unused(machine.unused.begin(), machine.unused.end());
    std::fprintf(stderr, "Architecture %s: not used by this run: %s.\n", machine.architecture.name.c_str(),
                 joined(unused).c_str());
  }
}

ExitCode finish_result(Result& result, size_t planned, const std::vector<ResolvedArchitecture>& machines,
                       Fidelity fidelity, ResultFolder& folder, const RunOptions& options,
                       std::chrono::steady_clock::time_point start) {
  size_t whole = 0;
  for (const RunEntry& run : result.runs) whole += !run.partial();
  if (result.runs.empty()) {
    throw Error(ExitCode::kIncomplete, "Stopped before the first run began; nothing is kept.");
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  char wall[32];
  std::snprintf(wall, sizeof wall, "%.3f", seconds.count());
  result.manifest.environment.emplace_back("ended", time_now(kTimeOfDay));
  result.manifest.environment.emplace_back("wall_seconds", wall);
  if (whole < planned) {
    result.manifest.environment.emplace_back(
        "stopped", std::to_string(whole) + " of " + std::to_string(planned) + " runs are whole");
  }
  write_configurations(machines, fidelity, folder);
  write_result(result, folder);
  write_planes(result, folder);
  folder.commit(whole == planned);

  std::fputs((options.json ? result_json(result) : print_table(result)).c_str(), stdout);
  const fs::path report = folder.final_path() / "report.html";
  std::fprintf(options.json ? stderr : stdout, "Report: %s\n", report.c_str());
  flush_standard_output();
  if (whole == planned) return ExitCode::kOk;
  std::fprintf(stderr, "cuesta: stopped; %zu of %zu runs are whole, the rest is partial or missing.\n", whole,
               planned);
  return ExitCode::kIncomplete;
}

}  // namespace cuesta
