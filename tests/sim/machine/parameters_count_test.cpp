#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "sim/config/architecture_file.h"
#include "sim/config/parameters.h"
#include "sim/hardware/rtl_set.h"
#include "sim/session/measure.h"
#include "tests/support/temporary_folder.h"

// Turning a knob must be seen: every parameter of the machine changes some count, or says that it is inert.
namespace cuesta {
namespace {

/// Where a parameter matters: the preset `tiny` with these settings, over rough ground.
struct Case {
  std::string_view path;
  std::vector<std::string> values;  ///< each gives another digest than the others
  std::vector<std::string> settings = {};
  std::string algorithm = "yun2013";
};

// One row per parameter; whoever adds a parameter adds its row.
const std::vector<Case>& cases() {
  static const std::vector<std::string> kSmallL1 = {"height_l1.size_bytes=256", "height_l1.line_bytes=16",
                                                    "height_l1.ways=1"};
  static const std::vector<Case> rows = {
      {"machine.pipelines", {"1", "2", "4"}},
      {"machine.clock_mhz", {"100", "1000"}},
      {"machine.no_progress_cycles", {"100000", "200000"}},
      {"ray_dispatch.order", {"scanline", "tile", "morton", "hilbert"}},
      {"ray_dispatch.assign", {"first_free", "interleave"}, {"machine.pipelines=2"}},
      {"ray_dispatch.tile_size", {"4", "8"}, {"ray_dispatch.order=tile"}},
      {"ray_dispatch.queue_depth", {"1", "16"}, {"machine.pipelines=2"}},
      {"ray_dispatch.latency_cycles", {"1", "50"}},
      {"ray_dispatch.credit_latency_cycles", {"1", "50"}, {"ray_dispatch.queue_depth=1"}},
      {"ray_setup.latency_cycles", {"10", "60"}},
      {"ray_setup.interval_cycles", {"1", "20"}},
      {"ray_setup.queue_depth", {"1", "8"}},
      {"traverse.arithmetic", {"fixed", "float", "double"}},
      {"traverse.stages", {"4", "8"}, {"traverse.contexts=8"}},
      {"traverse.contexts", {"8", "32"}, {"traverse.stages=8"}},
      {"traverse.fraction_bits", {"2", "8"}},
      {"traverse.direction_bits", {"12", "32"}},
      {"traverse.mantissa_bits", {"8", "16"}},
      {"traverse.tile_bits", {"3", "6"}},
      {"traverse.start", {"root", "leaf", "span"}},
      {"traverse.down", {"1", "2", "3", "common"}, {"traverse.start=root"}},
      {"traverse.up",
       {"never", "always", "interval", "even-axis", "both-even", "selective", "selective-even", "coherent"}},
      {"traverse.stop_level", {"0", "1", "2", "6"}},
      {"traverse.fetch", {"texel", "quad"}},
      {"height_l1.size_bytes", {"256", "4096"}},
      {"height_l1.line_bytes", {"16", "64"}, {"dram.bus_bytes=16"}},
      {"height_l1.ways", {"1", "4"}, {"height_l1.size_bytes=256", "height_l1.line_bytes=16"}},
      {"height_l1.mshrs", {"1", "8"}, kSmallL1},
      {"hit_queue.depth", {"1", "16"}, {"result_writer.outstanding=1", "result_writer.burst_bytes=32"}},
      {"result_writer.burst_bytes", {"32", "128"}},
      {"result_writer.outstanding", {"1", "8"}, {"result_writer.burst_bytes=32"}},
      {"dram.channels", {"1", "4"}, kSmallL1},
      {"dram.banks", {"1", "8"}, kSmallL1},
      {"dram.row_bytes", {"256", "4096"}, kSmallL1},
      {"dram.bus_bytes", {"1", "16"}},
      {"dram.tRCD", {"5", "20"}, {"dram.tRAS=30"}},
      {"dram.tRP", {"5", "50"}, {"dram.banks=1", "dram.row_bytes=256"}},
      {"dram.tCL", {"5", "20"}},
      {"dram.tRAS", {"30", "500"}, {"dram.banks=1", "dram.row_bytes=256"}},
      {"dram.clock_num", {"1", "5"}},
      {"dram.clock_den", {"1", "5"}},
      {"dram.request_latency_cycles", {"5", "50"}},
      {"dram.response_latency_cycles", {"5", "50"}},
      {"texels.layout", {"row_major", "morton", "mip_atlas", "blocks_4x4", "ki2007_slices"}, kSmallL1},
      {"units.hmt_top", {"model", "rtl"}},
      {"units.traverse", {"model", "rtl"}},
  };
  return rows;
}

const Case* case_of(std::string_view path) {
  for (const Case& row : cases()) {
    if (row.path == path) return &row;
  }
  return nullptr;
}

/// Rough ground, which repeats; rays at every angle, some of which cross many tiles.
Job rough_ground() {
  const TemporaryFolder folder;
  std::ofstream(folder.path("rough.toml"))
      << "[heightmap]\ngenerate = { kind = \"fractal\", size = 64, bits = 8 }\n"
         "[rays]\nset = \"adversarial\"\ncount = 1500\nseed = 3\ntile_bits = 3\n";
  return prepare_job(folder.path("rough.toml"), {});
}

/// What a run counts, in one text: digest over rays, hits, counters and planes, and every histogram.
std::string counted(Measurer& measurer, const Case& row, const std::string& value) {
  std::vector<std::string> settings = row.settings;
  settings.push_back(std::string(row.path) + "=" + value);
  const ResolvedArchitecture machine = resolve_architecture("tiny", settings, true);
  const RunEntry run = measurer.run(*find_algorithm(row.algorithm), machine.architecture, Fidelity::kCycle);
  std::string text = run.hits_digest + run.digest;
  for (const Histogram& histogram : run.measurements.histograms) {
    text += " " + histogram.name;
    for (size_t k = 0; k < histogram.first.size(); ++k) {
      text += " " + std::to_string(histogram.first[k]) + ":" + std::to_string(histogram.count[k]);
    }
  }
  return text;
}

TEST(EveryParameter, ChangesSomeCountOrSaysThatItIsInert) {
  const Job job = rough_ground();
  Measurer measurer(job);
  for (const Parameter& parameter : parameters()) {
    const Case* row = case_of(parameter.path);
    ASSERT_TRUE(row) << parameter.path << " has no row in this test's table";
    ASSERT_GE(row->values.size(), 2u) << parameter.path;
    if (parameter.section() == "units" && rtl::rtl_sets().empty()) continue;  // built without hardware
    std::set<std::string> seen;
    for (const std::string& value : row->values) seen.insert(counted(measurer, *row, value));
    EXPECT_EQ(seen.size(), parameter.inert.empty() ? row->values.size() : 1u) << parameter.path;
  }
}

TEST(EveryParameter, HasARowAndEveryRowAParameter) {
  for (const Case& row : cases()) EXPECT_TRUE(find_parameter(row.path)) << row.path;
  EXPECT_EQ(cases().size(), parameters().size());
}

}  // namespace
}  // namespace cuesta
