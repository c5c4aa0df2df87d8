#pragma once

#include <string>

#include "traces/ray_trace.h"

namespace cuesta {

/// Text form of a ray trace, without loss both ways: every number is the shortest decimal that reads back as the
/// same bits. Line 1 is `# cuesta rays 1, width W, height H`, line 2 names the columns, then a ray per line.

/// Throws Error(kResource) when the file cannot be written, input_error for a ray that no reader would accept. The
/// file appears under its name only when it is complete.
void write_rays_csv(const std::string& path, const RayTrace& trace, const RayWatch& watch = {});

/// Columns may stand in any order; id, origin_u, origin_v, origin_z, direction_u, direction_v and direction_z are
/// required, others take TracedRay's defaults. Throws input_error naming line and column.
RayTrace read_rays_csv(const std::string& path, const RayWatch& watch = {});

}  // namespace cuesta
