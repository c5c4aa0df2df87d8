#pragma once

#include <string>
#include <vector>

#include "models/files/sample_type.h"

namespace cuesta {

/// One channel of numbers of a file, read in strips of rows so that only what is wanted is ever in memory.
/// Everything throws cuesta::Error (input).
class SampleSource {
 public:
  virtual ~SampleSource() = default;
  virtual int width() const = 0;   ///< 1 to 16384
  virtual int height() const = 0;  ///< 1 to 16384
  virtual SampleKind kind() const = 0;
  /// Rows that the file gives at once, at least 1.
  virtual int strip_rows() const = 0;
  /// Rows [first, last) as numbers of `kind`, row by row. `first` is 0 or where the last call ended, a multiple of
  /// strip_rows(); `last` is another or height(). Reading may start again at 0.
  virtual void read_rows(int first, int last, void* target) = 0;
};

/// What a file without channels and colours says of itself, for the statement.
struct PlainFileFacts {
  std::string format;              ///< "raw", "hgt", "esri ascii grid"
  bool has_nodata = false;         ///< the format or the file names a marker of cells without data
  double nodata = 0;               ///< that marker
  std::string nodata_reason;       ///< where it stands
  std::vector<std::string> notes;  ///< one sentence each
};

}  // namespace cuesta
