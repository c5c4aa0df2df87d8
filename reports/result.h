#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/common/statistics.h"

namespace cuesta {

/// Changes with every change of result.json that a reader can notice.
inline constexpr std::string_view kResultSchema = "cuesta-result-1";

/// A file that a run read.
struct Input {
  std::string role;    ///< "scene", "heightmap", "rays", "architecture"
  std::string path;    ///< as the user wrote it
  std::string sha256;  ///< 64 hexadecimal digits, of the file's bytes
};

/// A parameter of the machine that a run used.
struct UsedParameter {
  std::string path;  ///< "height_l1.line_bytes"
  int64_t value = 0;
  std::string unit;  ///< "bytes"; empty for a plain number or a choice
};

/// The resolved parameters that a run used, in the order of `cuesta list parameters`. Reports take from them by path;
/// 0 means "does not apply", and nothing derived from it is shown.
struct MachineFacts {
  std::vector<UsedParameter> parameters;
  int texel_bytes = 0;  ///< one height fetch: of the map, not of the machine

  /// Gives a parameter's value, or `absent` where the run did not use it.
  int64_t at(std::string_view path, int64_t absent = 0) const;

  int64_t pipelines() const;         ///< 1 where it is not known
  int64_t clock_mhz() const;         ///< 0 where the fidelity has no time
  int64_t line_bytes() const;        ///< of the height L1
  int64_t dram_peak_bytes() const;   ///< that all channels can carry in dram_peak_cycles() machine cycles
  int64_t dram_peak_cycles() const;  ///< 1 where there is no DRAM
};

/// One run of one algorithm on one machine.
struct RunEntry {
  std::string scene;  ///< short names, as `list` and the files call them
  std::string algorithm;
  std::string architecture;
  std::string fidelity;  ///< "functional", "transaction", "cycle", "rtl"
  MachineFacts machine;
  Measurements measurements;
  std::string hits_digest;  ///< 64 hexadecimal digits
  std::string digest;       ///< empty when partial
  uint64_t finished_rays = 0;
  uint64_t all_rays = 0;

  bool partial() const { return finished_rays < all_rays; }
};

/// Where a result comes from. The `environment` may differ between two equal results, the rest may not.
struct ManifestInfo {
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  std::string version;
  std::string commit;  ///< "unknown" outside a git tree
  std::string compiler;
  std::string flags;  ///< of the compiler
  Pairs libraries;    ///< name, version
  Pairs seeds;        ///< what is seeded, seed
  Pairs environment;  ///< host, command line, times of day, wall seconds
};

/// All that one command measured: the one thing that every report is made from.
struct Result {
  std::string command = "run";  ///< "run" or "compare"
  std::vector<Input> inputs;
  std::vector<RunEntry> runs;  ///< in the order asked for; tables and plots keep it
  ManifestInfo manifest;
};

/// Name of a run within its result: the parts that tell it from the others, the algorithm always.
std::string label_of(const Result& result, const RunEntry& run);

/// `label_of` (and the scene, where there are several) made fit for a file name: unique within the result.
std::string file_stem_of(const Result& result, size_t run_index);

/// Indices of the runs of one scene: what may be compared, the same rays.
struct RunGroup {
  std::string scene;
  std::vector<size_t> runs;
};

/// Scenes in order of first appearance.
std::vector<RunGroup> group_by_scene(const Result& result);

/// Level of the leaves that a run's algorithm stopped at, as its name says: "0", or N of `:stop=N`. Runs of different
/// levels see different heights: they are not held against each other.
std::string_view level_of_detail(const RunEntry& run);

/// The run that `run` is held against: `oh2006` with the same scene, architecture and fidelity. Where no run
/// of the result is `oh2006`, the scene's first run. nullptr where there is none.
const RunEntry* baseline_of(const Result& result, const RunEntry& run);

/// The one baseline of all runs of a scene; nullptr where they have several (one for each machine) or none.
const RunEntry* common_baseline(const Result& result, const RunGroup& group);

/// What the runs of a scene are held against, for headings: the common baseline's label, or "oh2006" where each
/// machine has its own; empty where there is none.
std::string baseline_name(const Result& result, const RunGroup& group);

}  // namespace cuesta
