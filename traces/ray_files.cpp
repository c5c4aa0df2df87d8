#include "traces/ray_files.h"

#include "traces/rays_csv.h"
#include "traces/rays_reader.h"
#include "traces/rays_writer.h"

namespace cuesta {

bool is_csv_name(const std::string& path) {
  if (path.size() < 4) return false;
  std::string ending = path.substr(path.size() - 4);
  for (char& letter : ending)
    letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  return ending == ".csv";
}

RayTrace read_ray_file(const std::string& path, const RayWatch& watch) {
  return is_csv_name(path) ? read_rays_csv(path, watch) : read_rays(path, watch);
}

void write_ray_file(const std::string& path, const RayTrace& trace, const RayWatch& watch) {
  is_csv_name(path) ? write_rays_csv(path, trace, watch) : write_rays(path, trace, watch);
}

}  // namespace cuesta
