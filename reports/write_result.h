#pragma once

#include "reports/result.h"
#include "reports/result_folder.h"

namespace cuesta {

/// Everything that a result folder holds but the resolved configuration: result.json, result.csv, summary.csv,
/// manifest.json, report.html, heatmaps/*.png. Planes: `write_planes` (image_write.h).
void write_result(const Result& result, ResultFolder& folder);

}  // namespace cuesta
