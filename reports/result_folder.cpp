#include "reports/result_folder.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

#include "models/common/error.h"

namespace cuesta {
namespace {

namespace fs = std::filesystem;

Error cannot(const std::string& what, const fs::path& path, const std::string& why) {
  return {ExitCode::kResource, "Cannot " + what + " '" + path.string() + "': " + why + "."};
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type() != fs::file_type::not_found;
}

/// Whether a result holds a file of that name (relative to its folder).
bool belongs_to_a_result(const fs::path& relative) {
  static constexpr const char* kFiles[] = {"result.json", "result.csv", "summary.csv", "manifest.json",
                                           "report.html", "data.json",  "data.csv"};
  const std::string name = relative.string();
  for (const char* file : kFiles) {
    if (name == file) return true;
  }
  return (name.starts_with("config.resolved") && relative.extension() == ".toml") || name == "heatmaps" ||
         name == "planes" || (relative.parent_path() == "heatmaps" && relative.extension() == ".png") ||
         (relative.parent_path() == "planes" && relative.extension() == ".exr");
}

/// What a study's folder holds beside these.
bool belongs_to_a_study(const fs::path& relative) {
  const std::string name = relative.string();
  return name == "README.md" || name == "times.json" || name == "pictures" ||
         (relative.parent_path() == "pictures" && relative.extension() == ".png");
}

/// What an adversary's folder holds: a case with its scene.
bool belongs_to_a_case(const fs::path& relative) {
  static constexpr const char* kFiles[] = {"case.toml", "scene.toml", "map.png", "rays.csv", "README.md"};
  return std::any_of(std::begin(kFiles), std::end(kFiles),
                     [&](const char* file) { return relative == file; });
}

/// An empty folder, or one that a `commit` has made and nobody has added to.
bool is_result_folder(const fs::path& path) {
  std::error_code error;
  if (fs::symlink_status(path, error).type() != fs::file_type::directory) return false;
  if (fs::is_empty(path, error)) return true;
  const bool study = is_there(path / "data.json"), found = is_there(path / "case.toml");
  if (!found && (!(study || is_there(path / "result.json")) || !is_there(path / "manifest.json")))
    return false;
  for (const auto& entry : fs::recursive_directory_iterator(path, error)) {
    const fs::path relative = entry.path().lexically_relative(path);
    if (found ? belongs_to_a_case(relative)
              : belongs_to_a_result(relative) || (study && belongs_to_a_study(relative))) {
      continue;
    }
    return false;
  }
  return !error;
}

bool is_empty_folder(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type() == fs::file_type::directory && fs::is_empty(path, error);
}

void check_free(const fs::path& path, bool overwrite) {
  std::error_code error;
  if (fs::symlink_status(path, error).type() == fs::file_type::none) {  // a name too long, no permission
    throw usage_error("'" + path.string() + "' cannot be a result folder: " + error.message() + ".");
  }
  if (!is_there(path) || is_empty_folder(path)) return;
  if (!overwrite) {
    throw usage_error("The result folder '" + path.string() +
                      "' exists; results never go over old ones unless --overwrite is given.");
  }
  if (!is_result_folder(path)) {
    throw usage_error(
        "'" + path.string() +
        "' exists and is not a result folder (one that holds what a result has and nothing else, or an empty "
        "one), so --overwrite does not replace it.");
  }
}

fs::path make_staging(const fs::path& final_path) {
  std::string name =
      (final_path.parent_path() / ("." + final_path.filename().string() + ".unfinished-XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr) throw cannot("make a folder beside", final_path, std::strerror(errno));
  const mode_t mask = umask(0);
  umask(mask);
  chmod(name.c_str(), 0777 & ~mask);
  return name;
}

/// False when something has that name. Throws when the folder cannot be renamed; `from` is gone or kept whole.
bool rename_if_free(const fs::path& from, const fs::path& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno == EEXIST) return is_empty_folder(to) && std::rename(from.c_str(), to.c_str()) == 0;
  if (errno != EINVAL) throw cannot("rename the finished folder to", to, std::strerror(errno));
  if (is_there(to)) return false;  // a file system without RENAME_NOREPLACE
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw cannot("rename the finished folder to", to, error.message());
  return true;
}

/// In one step where the file system can; else the old one moves aside first.
void swap_folders(const fs::path& a, const fs::path& b) {
  if (renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0) return;
  if (errno != EINVAL) throw cannot("replace", b, std::strerror(errno));
  const fs::path aside = a.string() + "-old";
  std::error_code error;
  fs::rename(b, aside, error);
  if (error) throw cannot("move aside", b, error.message());
  fs::rename(a, b, error);
  if (error) {
    std::error_code back;
    fs::rename(aside, b, back);
    throw cannot("replace", b, error.message());
  }
  fs::rename(aside, a, error);
}

}  // namespace

ResultFolder ResultFolder::create(const fs::path& path, bool overwrite) {
  std::error_code error;
  fs::path final_path = fs::absolute(path, error).lexically_normal();
  if (!final_path.has_filename()) final_path = final_path.parent_path();
  if (path.empty() || error || !final_path.has_filename()) {
    throw usage_error("'" + path.string() +
                      "' cannot be a result folder; a name that does not exist yet is accepted.");
  }
  check_free(final_path, overwrite);
  fs::create_directories(final_path.parent_path(), error);
  if (error) throw cannot("make the folder", final_path.parent_path(), error.message());
  return {final_path, make_staging(final_path), overwrite};
}

ResultFolder::ResultFolder(fs::path final_path, fs::path staging, bool overwrite)
    : final_(std::move(final_path)), staging_(std::move(staging)), overwrite_(overwrite) {}

ResultFolder::ResultFolder(ResultFolder&& other) noexcept
    : final_(std::move(other.final_)), staging_(std::move(other.staging_)), overwrite_(other.overwrite_) {
  other.staging_.clear();
}

ResultFolder::~ResultFolder() {
  std::error_code error;
  if (!staging_.empty()) fs::remove_all(staging_, error);
}

fs::path ResultFolder::file(const fs::path& relative) {
  const fs::path path = staging_ / relative;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) throw cannot("make the folder", path.parent_path(), error.message());
  return path;
}

void ResultFolder::write(const fs::path& relative, std::string_view bytes) {
  const fs::path path = file(relative);
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) throw cannot("write", path, "the disk may be full or the folder not writable");
}

void ResultFolder::commit(bool whole) {
  const fs::path wanted = final_;
  for (int number = 2; !rename_if_free(staging_, final_); ++number) {
    if (number == 2 && overwrite_ && whole && is_result_folder(final_)) {
      swap_folders(staging_, final_);
      return;  // what is staged now is the old result, and goes
    }
    final_ = wanted.string() + "-" + std::to_string(number);
  }
  staging_.clear();
}

}  // namespace cuesta
