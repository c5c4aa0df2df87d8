#include "sim/measure.h"

#include <gtest/gtest.h>

#include "models/common/error.h"
#include "models/heightmap/generator.h"
#include "traces/ray_sets.h"

// Schedules and address modes through whole runs, in both fidelities.

namespace cuesta {
namespace {

Job job_on(int width, int height, AddressMode mode) {
  Job job;
  job.scene.name = "made";
  job.pyramid = build_max_pyramid(generate("rocks", width, height, 8, 3));
  job.map = {width, height, job.pyramid.root_level(), 8, mode};
  job.trace = make_ray_set({"stratified", 300, 7}, job.map);
  for (const TracedRay& ray : job.trace.rays) {
    job.pixel_of_ray.push_back(ray.pixel_y * static_cast<uint32_t>(job.trace.width) + ray.pixel_x);
  }
  return job;
}

constexpr AddressMode kModes[] = {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kMirror,
                                  AddressMode::kClamp};

TEST(Measurer, BothFidelitiesFindTheSameHitsAndFetchesInEveryModeWithEverySchedule) {
  for (const AddressMode mode : kModes) {
    for (const int width : {64, 45}) {
      const Job job = job_on(width, 64, mode);
      Measurer measurer(job);
      for (const char* name : {"yun2013", "oh2006:quad", "root:common:never", "span:3:coherent:stop=2:quad",
                               "dda:stop=2", "span:common:always:stop=6", "yun2013-up:stop=1:quad"}) {
        const Algorithm algorithm = parse_algorithm(name);
        const Architecture machine;
        const RunEntry plain = measurer.run(algorithm, machine, Fidelity::kFunctional);
        const RunEntry timed = measurer.run(algorithm, machine, Fidelity::kCycle);
        EXPECT_EQ(plain.hits_digest, timed.hits_digest) << name;
        EXPECT_GT(plain.measurements.counters.get("machine.hits"), 50);
        for (const char* counter :
             {"machine.steps", "machine.fetches", "machine.fetched_texels", "machine.texel_bytes"}) {
          EXPECT_EQ(plain.measurements.counters.get(counter), timed.measurements.counters.get(counter))
              << name;
        }
      }
    }
  }
}

TEST(Measurer, QuadsLeaveHitsAndStepsAndSaveFetchesUnlessEveryCrossingGoesUp) {
  // In border mode: a ray that crosses from tile to tile on the root, the only one there, keeps it.
  const Job job = job_on(64, 64, AddressMode::kBorder);
  Measurer measurer(job);
  const Architecture machine;
  for (const Algorithm& texel : algorithms()) {
    const RunEntry one = measurer.run(texel, machine, Fidelity::kFunctional);
    const RunEntry four = measurer.run(parse_algorithm(texel.id + ":quad"), machine, Fidelity::kFunctional);
    EXPECT_EQ(one.hits_digest, four.hits_digest) << texel.id;
    const int64_t steps = one.measurements.counters.get("machine.steps");
    const int64_t fetches = four.measurements.counters.get("machine.fetches");
    EXPECT_EQ(one.measurements.counters.get("machine.fetches"), steps);
    if (texel.schedule.up == UpRule::kAlways) {
      EXPECT_EQ(fetches, steps) << texel.id;
    } else {
      EXPECT_LT(fetches, steps) << texel.id;
      EXPECT_GT(fetches, steps / 4) << texel.id;
    }
  }
}

TEST(Measurer, AnArchitecturesScheduleTakesThePlaceOfTheAlgorithmsAndNamesTheRun) {
  const Job job = job_on(32, 32, AddressMode::kWrap);
  Measurer measurer(job);
  Architecture machine;
  machine.traverse.up = UpRule::kSelectiveEven;
  EXPECT_EQ(measurer.run(*find_algorithm("oh2006"), machine, Fidelity::kFunctional).algorithm, "yun2013-up");
  machine.traverse.start = StartRule::kSpan;
  machine.traverse.down = 2;
  const RunEntry made = measurer.run(*find_algorithm("dda"), machine, Fidelity::kFunctional);
  EXPECT_EQ(made.algorithm, "yun2013");
  EXPECT_EQ(made.hits_digest,
            measurer.run(*find_algorithm("yun2013"), {}, Fidelity::kFunctional).hits_digest);
  machine.traverse.stop_level = 1;
  machine.traverse.fetch = FetchRule::kQuad;
  EXPECT_EQ(measurer.run(*find_algorithm("dda"), machine, Fidelity::kFunctional).algorithm,
            "yun2013:stop=1:quad");
  // Eight published algorithms, of which what is set makes one.
  EXPECT_EQ(distinct_on(machine, algorithms()).size(), 1u);
  EXPECT_EQ(distinct_on(Architecture{}, algorithms()).size(), 8u);
}

TEST(Measurer, RefusesAStopLevelAboveTheRoot) {
  const Job job = job_on(32, 20, AddressMode::kWrap);
  Measurer measurer(job);
  EXPECT_NO_THROW(measurer.run(parse_algorithm("oh2006:stop=5"), {}, Fidelity::kFunctional));
  try {
    measurer.run(parse_algorithm("oh2006:stop=6"), {}, Fidelity::kFunctional);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::kUsage);
    EXPECT_NE(std::string(error.what()).find("levels 0 to 5"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace cuesta
