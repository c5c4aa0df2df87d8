#include "sim/verify/laws/laws_check.h"

#include <gtest/gtest.h>

#include "models/algorithms/schedule.h"
#include "models/common/error.h"
#include "sim/session/machines.h"
#include "tests/sim/session/recording_observer.h"

namespace cuesta {
namespace {

LawsRequest on_tiny(const std::vector<std::string>& scenes) {
  return {scenes, resolve_machines(std::vector<std::string>{"tiny"}, {}, Fidelity::kCycle), 8};
}

TEST(LawsCheck, RunsEveryAlgorithmAtThreeFidelitiesOverEveryScene) {
  RecordingObserver observer;
  const LawsCounts counts = check_laws(on_tiny({"front", "grazing"}), observer);
  EXPECT_EQ(counts.planned, 2 * algorithms().size() * 3);
  EXPECT_EQ(counts.runs, counts.planned);
  EXPECT_GT(counts.rays, counts.runs * 30) << "8 x 8 pixels, most of them with a ray";
  EXPECT_LE(counts.rays, counts.runs * 64);
  EXPECT_FALSE(counts.stopped);
  EXPECT_EQ(observer.stages, std::vector<std::string>{"laws [runs " + std::to_string(counts.planned) + "]"});
}

TEST(LawsCheck, StoppedItSaysHowFarItCame) {
  RecordingObserver observer("laws");
  const LawsCounts counts = check_laws(on_tiny({"front"}), observer);
  EXPECT_TRUE(counts.stopped);
  EXPECT_EQ(counts.runs, 0u);
  EXPECT_EQ(counts.planned, algorithms().size() * 3);
}

TEST(LawsCheck, ASceneThatIsNotThereIsRefused) {
  Observer observer;
  EXPECT_THROW(check_laws(on_tiny({"nosuch"}), observer), Error);
}

}  // namespace
}  // namespace cuesta
