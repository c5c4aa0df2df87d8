#include "sim/session/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>

#include "models/common/error.h"
#include "models/heightmap/generator.h"
#include "models/work/functional_run.h"
#include "sim/config/on_architecture.h"
#include "traces/ray_sets.h"

// Schedules and address modes through whole runs, in both fidelities.

namespace cuesta {
namespace {

Job job_on(int width, int height, AddressMode mode, uint64_t rays = 300) {
  Job job;
  job.scene.name = "made";
  job.pyramid = build_max_pyramid(generate("rocks", width, height, 8, 3));
  job.map = {width, height, job.pyramid.root_level(), 8, mode};
  job.trace = make_ray_set({"stratified", rays, 7}, job.map);
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

TEST(Measurer, SearchesAsPrintedCountRaysWithoutAnAnswerApartInEveryFidelity) {
  const Job job = job_on(64, 64, AddressMode::kWrap);
  Measurer measurer(job);
  int64_t lost = 0;
  for (const char* name :
       {"ki2007-printed", "ki2007-printed:steps=50:delta=0", "ki2007-printed:linear",
        "ki2007-printed:delta=0:slope", "drobot2009-printed", "drobot2009-printed:slope"}) {
    const Algorithm search = parse_algorithm(name);
    EXPECT_EQ(search.id, name);
    const Architecture machine;
    const RunEntry plain = measurer.run(search, machine, Fidelity::kFunctional);
    for (const Fidelity fidelity : {Fidelity::kFunctional, Fidelity::kTransaction, Fidelity::kCycle}) {
      const RunEntry run = measurer.run(search, machine, fidelity);
      EXPECT_EQ(run.hits_digest, plain.hits_digest) << name;
      EXPECT_FALSE(run.partial());
      const Counters& a = run.measurements.counters;
      EXPECT_EQ(a.get("machine.rays"), static_cast<int64_t>(run.all_rays));
      EXPECT_EQ(a.get("machine.unfinished_rays"), 0);
      EXPECT_EQ(a.get("machine.rays"), a.get("error.exact") + a.get("error.tie") + a.get("error.wrong") +
                                           a.get("error.nan") + a.get("error.unfinished"));
      EXPECT_EQ(a.get("preprocessing.records"), 0);
      const auto wrong = std::ranges::find(run.measurements.planes, "plane.wrong", &Plane::name);
      ASSERT_NE(wrong, run.measurements.planes.end());
      EXPECT_EQ(std::accumulate(wrong->values.begin(), wrong->values.end(), int64_t{0}),
                a.get("error.wrong") + a.get("error.nan") + a.get("error.unfinished"));
    }
    lost +=
        plain.measurements.counters.get("error.nan") + plain.measurements.counters.get("error.unfinished");
  }
  EXPECT_GT(lost, 0);
}

TEST(Measurer, WhatAJobCannotDoIsRefusedWithoutARun) {
  const Job job = job_on(48, 64, AddressMode::kWrap);
  const Measurer measurer(job);
  EXPECT_NO_THROW(measurer.check(parse_algorithm("relief"), {}));
  EXPECT_THROW(measurer.check(parse_algorithm("ki2007-printed"), {}), Error);
  EXPECT_THROW(measurer.check(parse_algorithm("oh2006:stop=7"), {}), Error);
}

TEST(Measurer, SearchesReadAndFindTheSameInBothFidelitiesAndEveryRayHasOneVerdict) {
  for (const AddressMode mode : kModes) {
    const Job job = job_on(48, 64, mode);
    Measurer measurer(job);
    for (const Algorithm& named : searches()) {
      for (const char* ending : {"", ":bilinear"}) {
        const Algorithm search = parse_algorithm(named.id + ending);
        const Architecture machine;
        const RunEntry plain = measurer.run(search, machine, Fidelity::kFunctional);
        const RunEntry timed = measurer.run(search, machine, Fidelity::kCycle);
        EXPECT_EQ(plain.hits_digest, timed.hits_digest) << search.id;
        const Counters &a = plain.measurements.counters, &b = timed.measurements.counters;
        for (const char* counter : {"machine.steps", "machine.fetches", "machine.fetched_texels",
                                    "machine.texel_bytes", "error.exact", "error.wrong"}) {
          EXPECT_EQ(a.get(counter), b.get(counter)) << search.id << " " << counter;
        }
        EXPECT_EQ(a.get("machine.rays"), a.get("error.exact") + a.get("error.tie") + a.get("error.wrong"));
        EXPECT_EQ(a.get("error.wrong"),
                  a.get("error.missed") + a.get("error.behind") + a.get("error.wrong_cell"));
        EXPECT_EQ(b.get("preprocessing.bytes"), job.map.width * job.map.height * timed.machine.texel_bytes *
                                                    (named.id == "distance" ? 16 : 1));
      }
    }
  }
}

TEST(Measurer, SearchesKnowTheDepthOfTheSlabAtBothFidelities) {
  Job job = job_on(64, 64, AddressMode::kWrap);
  for (const char* name : {"pom", "pom-printed", "pom-tatarchuk", "parallax-limited"}) {
    std::set<std::string> digests;
    for (const double depth : {0.02, 0.5}) {
      job.scene.depth = depth;
      Measurer measurer(job);
      const Algorithm search = parse_algorithm(name);
      const RunEntry plain = measurer.run(search, {}, Fidelity::kFunctional);
      for (const Fidelity fidelity : {Fidelity::kTransaction, Fidelity::kCycle}) {
        EXPECT_EQ(plain.hits_digest, measurer.run(search, {}, fidelity).hits_digest)
            << name << " at " << depth;
      }
      digests.insert(plain.hits_digest);
    }
    EXPECT_EQ(digests.size(), 2u) << name;
  }
}

TEST(Measurer, ASearchWithManyStepsIsRarelyWrongAndWithFewOften) {
  const Job job = job_on(64, 64, AddressMode::kWrap);
  Measurer measurer(job);
  const auto wrong = [&](const char* search) {
    return measurer.run(parse_algorithm(search), {}, Fidelity::kFunctional)
        .measurements.counters.get("error.wrong");
  };
  const int64_t few = wrong("steep:steps=4"), many = wrong("steep:steps=4096");
  EXPECT_GT(few, 100);
  EXPECT_LT(many, few / 4);
}

TEST(Measurer, HardwareThatReturnsAWrongRecordEndsTheRunWithItsPixel) {
  const Job job = job_on(32, 32, AddressMode::kWrap);
  int wrong_ray = -1;
  Measurer measurer(job, [&](const Workload& work, std::span<const TracedRay>, const Architecture& machine,
                             const Progress& progress) {
    Architecture model = machine;
    model.units = {};
    Outcome outcome = run_cycle(work, model, progress);
    if (wrong_ray >= 0) outcome.hits[static_cast<size_t>(wrong_ray)].t ^= 1;
    return outcome;
  });
  Architecture machine;
  machine.units.hmt_top = Implementation::kRtl;
  EXPECT_NO_THROW(measurer.run(*find_algorithm("yun2013"), machine, Fidelity::kCycle));
  wrong_ray = 123;
  try {
    measurer.run(*find_algorithm("yun2013"), machine, Fidelity::kCycle);
    ADD_FAILURE() << "the wrong record went unnoticed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::kMismatch);
    const std::string text = error.what();
    const uint32_t pixel = job.pixel_of_ray[123], width = static_cast<uint32_t>(job.trace.width);
    const std::string place =
        "(" + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) + ")";
    EXPECT_NE(text.find("record of ray 123, pixel " + place), std::string::npos) << text;
  }
}

TEST(Measurer, CostsOfPixelsAddUpInARunThatIsStoppedToo) {
  const Job job = job_on(256, 256, AddressMode::kWrap, 60'000);
  const Architecture machine;
  const std::vector<MachineRay> rays = machine_rays(job, number_format(machine.traverse, job.map));
  const Workload work = workload_of(job, machine, rays, *find_algorithm("dda"));
  const auto stop = [](uint64_t finished, uint64_t) { return finished == 0; };
  for (const Outcome& outcome : {run_cycle(work, machine, stop), run_transaction(work, machine, stop)}) {
    ASSERT_GT(outcome.finished_rays, 0u);
    ASSERT_LT(outcome.finished_rays, rays.size());
    const Counters& counters = outcome.measurements.counters;
    const std::pair<const char*, int64_t> totals[] = {
        {"plane.steps", counters.get("machine.steps")},
        {"plane.issue_slots", counters.get("machine.cycles")},
        {"plane.l1_misses", counters.sum("height_l1", "misses")},
        {"plane.dram_read_bytes", counters.get("dram.read_bytes")},
        {"plane.dram_write_bytes", counters.get("dram.write_bytes")}};
    for (const auto& [name, total] : totals) {
      const auto plane = std::find_if(outcome.measurements.planes.begin(), outcome.measurements.planes.end(),
                                      [&](const Plane& p) { return p.name == name; });
      ASSERT_NE(plane, outcome.measurements.planes.end()) << name;
      EXPECT_EQ(std::accumulate(plane->values.begin(), plane->values.end(), plane->nobody), total) << name;
    }
  }
}

TEST(Measurer, AScheduleAskedOfASearchIsRefused) {
  const Job job = job_on(16, 16, AddressMode::kWrap);
  Measurer measurer(job);
  Architecture machine;
  machine.traverse.fetch = FetchRule::kQuad;
  EXPECT_THROW(measurer.run(parse_algorithm("relief"), machine, Fidelity::kFunctional), Error);
}

TEST(HitJudge, KnowsTheTruthAndWhatLiesBeforeBehindAndBeside) {
  const Job job = job_on(64, 64, AddressMode::kWrap);
  const Architecture machine;
  const NumberFormat format = number_format(machine.traverse, job.map);
  const std::vector<MachineRay> rays = machine_rays(job, format);
  const Workload work = workload_of(job, machine, rays, *find_algorithm("dda"));
  const std::vector<HitRecord> truth = run_functional(work).hits;
  HitJudge judge(work);
  const Judgement right = judge.judge(truth, Arithmetic::kFixed);
  EXPECT_EQ(right.counts.count(Verdict::kExact) + right.counts.count(Verdict::kTie), 300);
  for (const double error : right.height_errors) EXPECT_LT(error, 0.1);

  std::vector<HitRecord> missed = truth, behind = truth, before = truth;
  int64_t hits = 0;
  for (size_t k = 0; k < truth.size(); ++k) {
    if (truth[k].status != HitStatus::kHit) continue;
    ++hits;
    missed[k] = {};
    behind[k].i += 3;
    behind[k].t += behind[k].t / 8 + (int64_t{1} << 20);
    before[k].i += 3;
    before[k].t = 0;
  }
  ASSERT_GT(hits, 100);
  EXPECT_EQ(judge.judge(missed, Arithmetic::kFixed).counts.count(Verdict::kMissed), hits);
  EXPECT_GT(judge.judge(behind, Arithmetic::kFixed).counts.count(Verdict::kBehind), hits * 9 / 10);
  EXPECT_GT(judge.judge(before, Arithmetic::kFixed).counts.count(Verdict::kWrongCell), hits * 9 / 10);
}

TEST(Measurer, BothFidelitiesFindTheSameHitsAndFetchesOnABilinearSurface) {
  for (const AddressMode mode : {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kClamp}) {
    for (const int width : {64, 45}) {
      Job job = job_on(width, 64, mode);
      job.map.surface = job.scene.surface = Surface::kBilinear;
      job.pyramid = build_four_corner_pyramid(std::move(job.pyramid), mode == AddressMode::kWrap);
      Measurer measurer(job);
      EXPECT_THROW(measurer.run(parse_algorithm("relief"), {}, Fidelity::kFunctional), Error);
      for (const char* name : {"dda", "yun2013", "oh2006:quad", "root:common:never"}) {
        const Algorithm algorithm = parse_algorithm(name);
        Architecture machine;
        machine.traverse.arithmetic = Arithmetic::kFloat;
        const RunEntry plain = measurer.run(algorithm, machine, Fidelity::kFunctional);
        const RunEntry timed = measurer.run(algorithm, machine, Fidelity::kCycle);
        EXPECT_EQ(plain.hits_digest, timed.hits_digest) << name;
        const Counters &counters = plain.measurements.counters, &in_time = timed.measurements.counters;
        EXPECT_GT(counters.get("machine.hits"), 50);
        for (const char* counter :
             {"machine.steps", "machine.fetches", "machine.fetched_texels", "machine.texel_bytes"}) {
          EXPECT_EQ(counters.get(counter), in_time.get(counter)) << name;
        }
        // The plain walk visits leaves alone: four samples each but at the edge that is repeated.
        const int64_t steps = counters.get("machine.steps"), texels = counters.get("machine.fetched_texels");
        if (algorithm.id == "dda" && mode == AddressMode::kWrap) {
          EXPECT_EQ(texels, 4 * steps);
        } else {
          // With quads a ray keeps siblings, so that most of its steps above the leaves read nothing.
          if (algorithm.schedule.fetch == FetchRule::kTexel) EXPECT_GT(texels, steps) << name;
          EXPECT_LT(texels, 4 * steps) << name;
        }
        // A step whose samples lie in several lines takes a slot for each.
        EXPECT_GT(in_time.sum("traverse", "slots_part"), 0);
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
