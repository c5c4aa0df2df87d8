#include "models/common/error.h"
#include "tests/fuzz/scratch_file.h"
#include "traces/rays_csv.h"

void cuesta::fuzz::csv(Bytes bytes) {
  try {
    const RayTrace trace = read_rays_csv(scratch_file("in.csv", bytes));
    const std::string again = scratch_file("again.csv", {});
    write_rays_csv(again, trace);
    require(identical(trace, read_rays_csv(again)), "what was read comes back the same from a file");
  } catch (const Error&) {
  }
}
