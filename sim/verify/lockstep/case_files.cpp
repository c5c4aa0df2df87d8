#include "sim/verify/lockstep/case_files.h"

#include <fmt/core.h>

#include <charconv>
#include <fstream>
#include <span>

#include "models/common/error.h"
#include "models/common/words.h"
#include "sim/config/architecture_file.h"
#include "sim/config/parameters.h"
#include "traces/heightmaps/image_writer.h"
#include "traces/rays_writer.h"

namespace cuesta {
namespace {

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw Error(ExitCode::kResource, "Cannot write " + path.string() + ".");
}

std::string scene_text(const LockstepCase& one) {
  return fmt::format(
      "description = \"The smallest workload on which two machines differ\"\n\n[heightmap]\nfile = "
      "\"heights.png\"\nbits = {}\naddress_mode = \"{}\"\n\n[rays]\nfile = \"rays.rays\"\n",
      one.pyramid->bits(), name_of(one.address_mode));
}

std::string architecture_text(const Architecture& architecture) {
  ResolvedArchitecture resolved;
  resolved.architecture = architecture;
  resolved.origins.assign(parameters().size(), "the case");
  return resolved.toml(true);
}

/// "SEED:n,n,...": the seed, and exactly as many numbers as `numbers` has places, each 0 to `most`.
uint64_t parse_seeded(const std::string& text, const std::string& option, const std::string& accepted,
                      int most, std::span<int> numbers) {
  const char *at = text.data(), *end = text.data() + text.size();
  uint64_t seed = 0;
  auto [next, fault] = std::from_chars(at, end, seed);
  bool good = fault == std::errc{};
  for (size_t k = 0; k < numbers.size() && good; ++k) {
    good = next != end && *next == (k == 0 ? ':' : ',');
    if (!good) break;
    const auto [after, wrong] = std::from_chars(next + 1, end, numbers[k]);
    good = wrong == std::errc{} && numbers[k] >= 0 && numbers[k] <= most;
    next = after;
  }
  if (!good || next != end)
    throw usage_error(option + " " + printable(text) + ": accepted is " + accepted + ".");
  return seed;
}

}  // namespace

std::string write_case(const LockstepCase& one, const std::filesystem::path& folder,
                       const std::filesystem::path& named) {
  const Pyramid& pyramid = *one.pyramid;
  HeightGrid grid{pyramid.width(0), pyramid.height(0), pyramid.bits(), {}};
  grid.texels.assign(pyramid.level(0),
                     pyramid.level(0) + static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height));
  write_height_image((folder / "heights.png").string(), grid);
  write_rays((folder / "rays.rays").string(), {one.width, one.height, one.rays});
  write_text(folder / "scene.toml", scene_text(one));
  write_text(folder / "architecture.toml", architecture_text(one.machine.architecture));

  std::string arguments = fmt::format("{} --arch {} --algorithm {}", (named / "scene.toml").string(),
                                      (named / "architecture.toml").string(), name_of(one.machine.schedule));
  for (const uint16_t chance : one.machine.stalls.per_mille) {
    if (chance == 0) continue;
    arguments += " --stalls " + text_of(one.machine.stalls);
    break;
  }
  if (one.machine.register_seed != 0)
    arguments += fmt::format(" --register-seed {}", one.machine.register_seed);
  if (one.machine.memory) arguments += " --memory " + text_of(*one.machine.memory);
  return arguments;
}

PortStalls parse_stalls(const std::string& text, const std::string& option) {
  int chances[kPortCount] = {};
  PortStalls stalls;
  stalls.seed =
      parse_seeded(text, option,
                   "SEED:p,p,p,p,p,p,p,p, the chance of a stall per mille, 0 to 999, at each of the 8 "
                   "ports along the data's way",
                   999, chances);
  for (int port = 0; port < kPortCount; ++port) stalls.per_mille[port] = static_cast<uint16_t>(chances[port]);
  return stalls;
}

MemoryTiming parse_memory_timing(const std::string& text, const std::string& option) {
  int numbers[3] = {};
  const std::string accepted =
      "SEED:LEAST,MOST,GAP in cycles up to 1000000: the answer's latency, LEAST <= MOST, and the most "
      "between two rays";
  MemoryTiming timing;
  timing.seed = parse_seeded(text, option, accepted, 1000000, numbers);
  if (numbers[0] > numbers[1])
    throw usage_error(option + " " + printable(text) + ": accepted is " + accepted + ".");
  timing.least_cycles = numbers[0];
  timing.most_cycles = numbers[1];
  timing.most_gap_cycles = numbers[2];
  return timing;
}

}  // namespace cuesta
