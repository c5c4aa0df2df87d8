#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "models/algorithms/schedule.h"
#include "models/heightmap/generator.h"
#include "models/heightmap/pyramid.h"
#include "models/work/functional_run.h"
#include "sim/config/architecture_file.h"
#include "sim/config/on_architecture.h"
#include "sim/machine/machine.h"
#include "traces/front_end.h"
#include "traces/scene_library.h"

// The digests of `cuesta compare default --size 64x48 --arch tiny`, and of the searches as printed, in every
// arithmetic and fidelity, from the camera to the planes, without the files and the command line of the program:
// small enough to be built by every compiler.

namespace cuesta {
namespace {

void print_digests() {
  Scene scene = find_scene("default");
  scene.width = 64;
  scene.height = 48;
  const GeneratedHeights& made = scene.generated;
  const HeightGrid grid = generate(made.kind, made.width, made.height, made.bits, made.seed);
  const Pyramid pyramid = build_max_pyramid(grid);
  const MapShape map{grid.width, grid.height, pyramid.root_level(), grid.bits, scene.address_mode};
  const RayTrace trace = make_rays(scene, map);
  std::vector<uint32_t> pixels;
  for (const TracedRay& ray : trace.rays) {
    pixels.push_back(ray.pixel_y * static_cast<uint32_t>(trace.width) + ray.pixel_x);
  }
  struct Case {
    const char* name;
    Arithmetic arithmetic;
    Fidelity fidelity;
  };
  // The functional path has code of its own for fixed point only.
  for (const Case& wanted : {Case{"fixed cycle", Arithmetic::kFixed, Fidelity::kCycle},
                             Case{"float cycle", Arithmetic::kFloat, Fidelity::kCycle},
                             Case{"double cycle", Arithmetic::kDouble, Fidelity::kCycle},
                             Case{"fixed functional", Arithmetic::kFixed, Fidelity::kFunctional}}) {
    Architecture architecture = resolve_architecture("tiny", {}, true).architecture;
    architecture.traverse.arithmetic = wanted.arithmetic;
    const NumberFormat format = number_format(architecture.traverse, map);
    std::vector<MachineRay> rays;
    for (const TracedRay& ray : trace.rays) rays.push_back(quantise(ray, map, format));
    std::vector<Algorithm> all(algorithms().begin(), algorithms().end());
    all.insert(all.end(), printed_searches().begin(), printed_searches().end());
    all.push_back(parse_algorithm("ki2007-printed:linear"));
    for (const Algorithm& algorithm : all) {
      Workload work;
      work.pyramid = &pyramid;
      work.map = map;
      set_numbers(work, architecture);
      work.rays = rays;
      work.pixel_of_ray = pixels;
      work.width = trace.width;
      work.height = trace.height;
      work.schedule = algorithm.schedule;
      std::optional<SearchMap> search_map;
      if (algorithm.search) {
        work.search = algorithm.search;
        work.search_map = &search_map.emplace(*algorithm.search, pyramid, map.address_mode);
        work.depth = scene.depth;
      }
      const Outcome outcome =
          wanted.fidelity == Fidelity::kCycle ? run_cycle(work, architecture) : run_functional(work);
      std::cout << wanted.name << ' ' << algorithm.id << ' ' << outcome.hits_digest << ' ' << outcome.digest
                << '\n';
    }
  }
}

}  // namespace
}  // namespace cuesta

int main() {
  try {
    cuesta::print_digests();
  } catch (const std::exception& fault) {
    std::cerr << "digest_probe: " << fault.what() << '\n';
    return 1;
  }
}
