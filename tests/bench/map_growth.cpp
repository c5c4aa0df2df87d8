#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "models/common/elementary.h"
#include "models/heightmap/generator.h"
#include "models/heightmap/pyramid.h"
#include "models/rays/machine_ray.h"
#include "models/work/functional_run.h"
#include "sim/config/on_architecture.h"
#include "sim/machine/machine.h"

// How steps, time and memory grow with the map: sides 256, 512 ... 16384 of one kind of map, 16 bits, 256 x 256
// parallel rays at 75 degrees from the normal over one tile of depth 0.1, functional, fixed point, every algorithm.
//
//   map_growth [KIND [LARGEST_SIDE]]      default: spikes 16384
//
// A size is done in a process of its own. `peak` is the process's largest resident set; `x map` divides it by the map
// and its pyramid in memory, 2 bytes a node. Rays and hits take 14 MiB of it at any size.

namespace cuesta {
namespace {

constexpr int kRaysAcross = 256;
constexpr double kDegrees = 75, kDepth = 0.1;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<MachineRay> parallel_rays(const MapShape& map, const NumberFormat& format) {
  std::vector<MachineRay> rays;
  for (uint32_t k = 0; k < kRaysAcross * kRaysAcross; ++k) {
    TracedRay ray;
    ray.id = k;
    ray.origin[0] = (k % kRaysAcross + 0.5) / kRaysAcross;
    ray.origin[1] = (static_cast<double>(k / kRaysAcross) + 0.5) / kRaysAcross;
    ray.origin[2] = 1;
    const double angle = elementary::radians(kDegrees), turn = 0.4;
    ray.direction[0] = elementary::sin(angle) * elementary::cos(turn);
    ray.direction[1] = elementary::sin(angle) * elementary::sin(turn);
    ray.direction[2] = -elementary::cos(angle) / kDepth;
    rays.push_back(quantise(ray, map, format));
  }
  return rays;
}

void print_row(const std::string& kind, int side) {
  auto start = std::chrono::steady_clock::now();
  HeightGrid grid = generate(kind, side, side, 16);
  const double make = seconds_since(start);
  start = std::chrono::steady_clock::now();
  const Pyramid pyramid = build_max_pyramid(std::move(grid));
  const double build = seconds_since(start);

  const MapShape map{side, side, pyramid.root_level(), 16, AddressMode::kWrap};
  const NumberFormat format = number_format({}, map);
  const std::vector<MachineRay> rays = parallel_rays(map, format);
  std::vector<uint32_t> pixels;
  for (uint32_t k = 0; k < rays.size(); ++k) pixels.push_back(k);
  std::string steps_text;
  start = std::chrono::steady_clock::now();
  for (const Algorithm& algorithm : algorithms()) {
    const Workload work{.pyramid = &pyramid,
                        .map = map,
                        .format = format,
                        .rays = rays,
                        .pixel_of_ray = pixels,
                        .width = kRaysAcross,
                        .height = kRaysAcross,
                        .schedule = algorithm.schedule};
    uint64_t steps = 0;
    for (const HitRecord& hit : run_functional(work).hits) steps += hit.steps;
    char text[32];
    std::snprintf(text, sizeof text, "%11.1f", static_cast<double>(steps) / static_cast<double>(rays.size()));
    steps_text += text;
  }
  const double traverse = seconds_since(start);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const double peak = static_cast<double>(usage.ru_maxrss) / 1024;  // MiB
  const double whole = 2.0 * static_cast<double>(pyramid.node_count()) / (1 << 20);
  std::printf("%6d %8.2f %10.4f %10.2f %9.0f %7.2f%s\n", side, make, build, traverse, peak, peak / whole,
              steps_text.c_str());
}

int print_table(const std::string& kind, int largest) {
  std::printf("%s\n%6s %8s %10s %10s %9s %7s", kind.c_str(), "side", "make s", "pyramid s", "traverse s",
              "peak MiB", "x map");
  for (const Algorithm& algorithm : algorithms()) std::printf(" %10.10s", algorithm.id.c_str());
  std::printf("   (steps per ray)\n");
  for (int side = 256; side <= largest; side *= 2) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      int code = 0;
      try {
        print_row(kind, side);
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        code = 1;
      }
      std::fflush(stdout);
      _exit(code);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0) return 1;
  }
  return 0;
}

}  // namespace
}  // namespace cuesta

int main(int argc, char** argv) {
  const std::string kind = argc > 1 ? argv[1] : "spikes";
  const int largest = argc > 2 ? std::atoi(argv[2]) : 16384;
  if (argc > 3 || cuesta::find_map_kind(kind) == nullptr || largest < 256 || largest > 16384) {
    std::fprintf(
        stderr, "usage: map_growth [KIND [LARGEST_SIDE]], a kind of `cuesta heightmap make`, 256 to 16384\n");
    return 2;
  }
  return cuesta::print_table(kind, largest);
}
