#include "sim/session/output_file.h"

#include <filesystem>

#include "models/common/error.h"

namespace cuesta {

void refuse_existing(const std::string& path, bool force) {
  std::error_code failure;
  const auto status = std::filesystem::symlink_status(path, failure);
  if (std::filesystem::is_directory(status)) {
    throw usage_error(path + " is a folder; accepted: the name of a file.");
  }
  if (!force && std::filesystem::exists(status)) {
    throw usage_error(path + " is there already and stays as it is; --force replaces it.");
  }
}

}  // namespace cuesta
