#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cuesta {

/// A result folder in the making. Files go into a hidden folder beside the final one; `commit` renames it, so
/// that the final name holds either nothing, an older whole result, or the new whole result.
class ResultFolder {
 public:
  /// Throws usage_error when `path` exists, is not an empty folder, and `overwrite` is false, or when it exists and
  /// is not a result folder (nothing else is ever replaced); Error(kResource) when nothing can be written there.
  static ResultFolder create(const std::filesystem::path& path, bool overwrite);

  ResultFolder(ResultFolder&& other) noexcept;
  ResultFolder& operator=(ResultFolder&&) = delete;
  ~ResultFolder();  ///< without `commit`, removes what was written

  /// Writes one file; `relative` may name folders, which are made. Throws Error(kResource).
  void write(const std::filesystem::path& relative, std::string_view bytes);

  /// Where writers that need a path of their own put their files; the file's folder exists afterwards.
  std::filesystem::path file(const std::filesystem::path& relative);

  /// Puts the folder under its final name; the last call. When something else has taken that name meanwhile, or
  /// when the new result is not `whole` and an older one stands there, it goes beside, as NAME-2, NAME-3 ...:
  /// `final_path` then says so. What was computed is never lost.
  void commit(bool whole = true);

  const std::filesystem::path& final_path() const { return final_; }

 private:
  ResultFolder(std::filesystem::path final_path, std::filesystem::path staging, bool overwrite);

  std::filesystem::path final_;
  std::filesystem::path staging_;  ///< empty after commit
  bool overwrite_;
};

}  // namespace cuesta
