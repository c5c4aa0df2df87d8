#include "sim/verify/lockstep/leave_difference.h"

#include "sim/verify/lockstep/case_files.h"

namespace cuesta {

std::string first_difference(const LockstepResult& result, const std::array<LockstepSide, 2>& sides) {
  const std::string names[2] = {sides[0].name, sides[1].name};
  return report(result.differences, names);
}

SmallestDifference shrink_difference(const LockstepReport& report, const std::array<LockstepSide, 2>& sides,
                                     Observer& observer) {
  observer.on_remark("verify rtl: looking for the smallest workload that differs ...");
  const auto differs = [&](const LockstepCase& candidate) {
    return !observer.wants_stop() &&
           !run_lockstep(candidate, sides[0], sides[1], LockstepDepth::kWhether).equal();
  };
  SmallestDifference smallest;
  smallest.shrunk = shrink(*report.failing, differs, report.last.rays);
  smallest.result = run_lockstep(smallest.shrunk.smallest, sides[0], sides[1]);
  return smallest;
}

std::string leave_difference(const LockstepReport& report, const SmallestDifference& smallest,
                             const std::array<LockstepSide, 2>& sides, HardwareUnit unit,
                             ResultFolder& folder) {
  const LockstepCase& one = smallest.shrunk.smallest;
  const std::string arguments = write_case(one, folder.file("scene.toml").parent_path(), folder.final_path());
  const std::string other_unit = unit == HardwareUnit::kHmtTop ? "" : " --unit " + std::string(name_of(unit));
  const std::string text = "\nthe smallest workload that differs, after " +
                           std::to_string(smallest.shrunk.runs) + " tries:\n" + describe(one) +
                           first_difference(smallest.result, sides) + "again: cuesta verify rtl " +
                           arguments + other_unit + "\n";
  leave_waves(one, sides[1], smallest.result.differences.at(0), folder.file("first_difference.fst").string());
  folder.write("difference.txt", describe(*report.failing) + first_difference(report.last, sides) + text);
  folder.commit();
  return text;
}

}  // namespace cuesta
