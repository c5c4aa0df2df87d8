#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "models/heightmap/generator.h"
#include "models/rays/map_shape.h"
#include "sim/config/architecture_file.h"
#include "sim/config/on_architecture.h"
#include "sim/machine/machine.h"
#include "traces/heightmaps/height_source_text.h"
#include "traces/parallel_view.h"
#include "traces/scene_heights.h"

// What filtering and levels of detail cost, beside table 1 and section 2.5 of Ki & Oh 2007 (printed: nearest over
// linear frame rates 1.687, 1.690, 1.700; level of detail about 2 times; best case n + 1 steps): 512 x 512 parallel
// rays over one tile's breadth, wrapped, in float on mobile. Their maps and views are not at hand.
//
//   ki_table [IMAGE[:CHANNEL]]      an image of a square power of two is a fourth map

namespace cuesta {
namespace {

struct Cost {
  double cycles = 0, texels = 0, steps = 0, least_steps = 0;  ///< cycles in all, the others a ray
};

/// A map with the rays of one view.
class View {
 public:
  View(const HeightGrid& grid, double angle_degrees, double depth, Surface surface)
      : pyramid_(build_max_pyramid(grid)), depth_(depth) {
    architecture_ = resolve_architecture("mobile", {}, true).architecture;
    architecture_.traverse.arithmetic = Arithmetic::kFloat;
    map_ = map_shape(grid.width, grid.height, grid.bits, AddressMode::kWrap);
    map_.surface = surface;
    if (surface == Surface::kBilinear) pyramid_ = build_four_corner_pyramid(std::move(pyramid_), true);
    const RayTrace picture = parallel_rays({angle_degrees, 25, depth, 1, 512, 512});
    const NumberFormat format = number_format(architecture_.traverse, map_);
    for (const TracedRay& ray : picture.rays) {
      pixels_.push_back(static_cast<uint32_t>(pixels_.size()));
      rays_.push_back(quantise(ray, map_, format));
    }
  }

  Cost cost(const std::string& name) const {
    const Algorithm algorithm = parse_algorithm(name);
    const int stop = algorithm.schedule.stop_level;
    const Pyramid stopped = stop > 0 ? build_stopped_pyramid(pyramid_, stop) : Pyramid();
    std::optional<SearchMap> map;
    Workload work;
    work.pyramid = stop > 0 ? &stopped : &pyramid_;
    work.map = map_;
    set_numbers(work, architecture_);
    work.rays = rays_;
    work.pixel_of_ray = pixels_;
    work.width = work.height = 512;
    work.schedule = algorithm.schedule;
    work.search = algorithm.search;
    work.depth = depth_;
    if (algorithm.search) work.search_map = &map.emplace(*algorithm.search, pyramid_, map_.address_mode);
    const Outcome outcome = run_cycle(work, architecture_);
    const auto rays = static_cast<double>(rays_.size());
    const auto count = [&](const char* counter) {
      return static_cast<double>(outcome.measurements.counters.get(counter));
    };
    Cost cost{count("machine.cycles"), count("machine.fetched_texels") / rays, count("machine.steps") / rays,
              1e9};
    for (const HitRecord& hit : outcome.hits)
      cost.least_steps = std::min<double>(cost.least_steps, hit.steps);
    return cost;
  }

 private:
  Pyramid pyramid_;
  double depth_;
  Architecture architecture_;
  MapShape map_;
  std::vector<MachineRay> rays_;
  std::vector<uint32_t> pixels_;
};

void print_filtering(const std::string& name, const HeightGrid& grid, const char* printed) {
  for (const double angle : {60.0, 80.0}) {
    const View texel(grid, angle, 0.35, Surface::kTexel), bilinear(grid, angle, 0.35, Surface::kBilinear);
    const Cost nearest = texel.cost("ki2007-printed"), linear = texel.cost("ki2007-printed:linear");
    std::printf("%-12s %5.0f  %10.3f %10.3f", name.c_str(), angle, linear.cycles / nearest.cycles,
                linear.texels / nearest.texels);
    for (const char* exact : {"oh2006", "yun2013"}) {
      const Cost flat = texel.cost(exact), patches = bilinear.cost(exact);
      std::printf(" %10.3f %10.3f", patches.cycles / flat.cycles, patches.texels / flat.texels);
    }
    std::printf("   %s\n", printed);
    std::fflush(stdout);
  }
}

void print_levels(const HeightGrid& grid) {
  std::printf(
      "\nLevel of detail, text 512 x 512, oh2006: cycles of level 0 over those of level N (printed: about "
      "2)\n");
  const std::pair<double, double> views[] = {{70, 0.05}, {80, 0.35}};
  for (const auto& [angle, depth] : views) {
    const View view(grid, angle, depth, Surface::kTexel);
    const double whole = view.cost("oh2006").cycles;
    std::printf("%2.0f degrees, depth %.2f:", angle, depth);
    for (int level = 1; level <= 3; ++level)
      std::printf("  %d: %.2f", level, whole / view.cost("oh2006:stop=" + std::to_string(level)).cycles);
    std::printf("\n");
  }
}

int run(const char* image) {
  std::printf(
      "Linear over nearest, depth 0.35\n%-12s %5s  %21s %21s %21s\n%-12s %5s  %10s %10s %10s %10s %10s %10s  "
      " %s\n",
      "map", "angle", "ki2007-printed", "oh2006", "yun2013", "", "", "cycles", "texels", "cycles", "texels",
      "cycles", "texels", "printed (frame rates)");
  const std::pair<const char*, const char*> maps[] = {
      {"hawaii", "1.687"}, {"rockbump", "1.690"}, {"logo", "1.700"}};
  for (const auto& [name, printed] : maps) print_filtering(name, generate(name, 256, 256, 8, 1), printed);
  if (image != nullptr) {
    Scene scene;
    scene.image = parse_height_source(image);
    print_filtering("image", heights_of(scene).grid, "1.690 (Rockbump)");
  }
  print_levels(generate("text", 512, 512, 8, 1));
  const View front(generate("hawaii", 256, 256, 8, 1), 0, 0.35, Surface::kTexel);
  std::printf("\nBest case on 256 x 256: %.0f steps (ki2007-printed), %.0f (oh2006); printed: n + 1 = 9\n",
              front.cost("ki2007-printed").least_steps, front.cost("oh2006").least_steps);
  return 0;
}

}  // namespace
}  // namespace cuesta

int main(int argc, char** argv) {
  try {
    if (argc <= 2) return cuesta::run(argc == 2 ? argv[1] : nullptr);
    std::fprintf(stderr, "usage: ki_table [IMAGE[:CHANNEL]]\n");
  } catch (const cuesta::Error& error) {
    std::fprintf(stderr, "ki_table: %s\n", error.what());
  }
  return 2;
}
