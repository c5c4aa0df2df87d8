#include "sim/cli/verbs.h"

namespace cuesta {
namespace {

constexpr Verb kVerbs[] = {
    {"run", "One algorithm on one machine: rays, traversal, timing, report.",
     "cuesta run default --algorithm yun2013 --arch mobile --set height_l1.ways=8 -o my-result",
     make_run_command},
    {"compare", "Several algorithms and machines on the same rays, side by side.",
     "cuesta compare default --algorithm dda,oh2006,yun2013 --arch tiny,mobile", make_compare_command},
    {"trace", "Writes a scene's rays into a file.", "cuesta trace default -o default.rays",
     make_trace_command},
    {"heightmap make", "Makes a heightmap: the same bytes from the same arguments, everywhere.",
     "cuesta heightmap make fractal -o hills.png --size 1024 --bits 16 --seed 7",
     make_heightmap_make_command},
    {"heightmap info", "What an image holds and how it is read as heights.",
     "cuesta heightmap info rocks.tga --channel A", make_heightmap_info_command},
    {"rays make", "Makes a set of rays without a camera: random, stratified, lattice or adversarial.",
     "cuesta rays make adversarial -o hard.rays --count 100000 --seed 7 --map-of default",
     make_rays_make_command},
    {"rays info", "What a ray trace holds.", "cuesta rays info default.rays", make_rays_info_command},
    {"rays convert", "A ray trace to CSV or back, by the name's ending.",
     "cuesta rays convert default.rays default.csv", make_rays_convert_command},
    {"rays check", "Reads a ray trace to its end and names what is damaged.",
     "cuesta rays check default.rays", make_rays_check_command},
    {"study", "Regenerates a published study: its data and its page.",
     "cuesta study iterations --quick -o iterations-quick", make_study_command},
    {"list", "What there is: algorithms, scenes, architectures, effects, parameters or statistics.",
     "cuesta list parameters", make_list_command},
    {"verify oracle", "Holds traversal against exact arithmetic, ray by ray.",
     "cuesta verify oracle --threads 2", make_verify_oracle_command},
    {"verify rtl", "Holds the model against the Verilated hardware, cycle by cycle.",
     "cuesta verify rtl --seconds 60 --workers 2", make_verify_rtl_command},
    {"verify laws", "Holds every algorithm on every machine against the conservation laws of the accounting.",
     "cuesta verify laws --size 64", make_verify_laws_command},
    {"adversary", "Searches for the map and the rays that are worst for an algorithm.",
     "cuesta adversary --algorithm yun2013 --maximise steps --tries 2000 -o worst", make_adversary_command},
};

struct Group {
  std::string_view name, sentence;
};

constexpr Group kVerbGroups[] = {
    {"heightmap", "Make a heightmap, or see what a file holds and how it will be read."},
    {"rays", "Make a set of rays, look into a ray trace, convert it to and from CSV, check it."},
    {"verify", "Hold results against exact arithmetic, the hardware or the laws of the accounting."},
};

}  // namespace

std::span<const Verb> verbs() { return kVerbs; }

std::string_view group_sentence(std::string_view group) {
  for (const Group& known : kVerbGroups) {
    if (known.name == group) return known.sentence;
  }
  return {};
}

}  // namespace cuesta
