#include "sim/session/manifest.h"

#include "models/common/build_info.h"
#include "models/common/digest.h"
#include "sim/session/host_facts.h"

namespace cuesta {

Result begin_result(const std::string& command, const std::string& command_line) {
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
      {"command_line", command_line}, {"host", host_name()}, {"started", time_now(kTimeOfDay)}};
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

}  // namespace cuesta
