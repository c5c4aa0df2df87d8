#pragma once

#include <string>

#include "reports/result.h"

namespace cuesta {

/// `result.json` as result.schema.json describes it: keys in a fixed order, counters by path, the same bytes
/// for the same result on every machine. Names a plane's file `planes/<run>.exr`.
/// Throws (internal error) for a counter, plane or histogram that models/common/statistics.cpp does not define.
std::string result_json(const Result& result);

/// `manifest.json`: versions, inputs, seeds, digests; times of day and host under `environment`.
std::string manifest_json(const Result& result);

/// Path within the result folder of the planes of one run.
std::string planes_path(const Result& result, size_t run_index);

}  // namespace cuesta
