#pragma once

#include <string>

#include "traces/ray_trace.h"

namespace cuesta {

/// Whether a file name ends in .csv, in any case: such a file holds the text form, every other one the binary.
bool is_csv_name(const std::string& path);

/// Of a file to write, before the work: throws usage_error for a name that ends in neither .rays nor .csv.
void check_ray_file_name(const std::string& path);

/// read_rays_csv for a .csv name, else read_rays.
RayTrace read_ray_file(const std::string& path, const RayWatch& watch = {});
/// write_rays_csv for a .csv name, else write_rays. Both throw Error(kIncomplete) when `watch` says stop: the file is
/// then not there.
void write_ray_file(const std::string& path, const RayTrace& trace, const RayWatch& watch = {});

}  // namespace cuesta
