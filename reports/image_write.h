#pragma once

#include <filesystem>

#include "models/common/statistics.h"
#include "reports/result.h"
#include "reports/result_folder.h"

namespace cuesta {

/// Writes all planes of one run into one EXR file: a channel per plane, named without "plane.", 32-bit unsigned
/// integers, ZIP compressed, no time of day inside. Throws Error(kResource) when it cannot be written.
void write_planes_exr(const std::filesystem::path& path, const Measurements& measurements);

/// `planes/<run>.exr` for every run that has planes, under the names that result.json gives.
void write_planes(const Result& result, ResultFolder& folder);

}  // namespace cuesta
