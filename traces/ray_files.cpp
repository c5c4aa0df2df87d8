#include "traces/ray_files.h"

#include "models/common/error.h"
#include "models/common/words.h"
#include "traces/rays_csv.h"
#include "traces/rays_reader.h"
#include "traces/rays_writer.h"

namespace cuesta {

namespace {

/// `ending` in small letters; found in any case.
bool ends_in(const std::string& path, std::string_view ending) {
  if (path.size() < ending.size()) return false;
  std::string found = path.substr(path.size() - ending.size());
  for (char& letter : found)
    letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  return found == ending;
}

}  // namespace

bool is_csv_name(const std::string& path) { return ends_in(path, ".csv"); }

void check_ray_file_name(const std::string& path) {
  if (is_csv_name(path) || ends_in(path, ".rays")) return;
  throw usage_error(
      "The name " + printable(path, 200) +
      " does not say how rays are to be written; accepted are names that end in .rays (binary) or "
      ".csv (text).");
}

RayTrace read_ray_file(const std::string& path, const RayWatch& watch) {
  return is_csv_name(path) ? read_rays_csv(path, watch) : read_rays(path, watch);
}

void write_ray_file(const std::string& path, const RayTrace& trace, const RayWatch& watch) {
  is_csv_name(path) ? write_rays_csv(path, trace, watch) : write_rays(path, trace, watch);
}

}  // namespace cuesta
