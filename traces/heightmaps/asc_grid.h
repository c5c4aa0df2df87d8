#pragma once

#include <fstream>
#include <string>

#include "traces/heightmaps/sample_source.h"

namespace cuesta {

/// True for names that end in .asc or .grd, in any case.
bool has_asc_name(const std::string& path);

/// An ESRI ASCII grid: a header of `ncols`, `nrows`, the corner, `cellsize` and maybe `NODATA_value` (-9999 where it
/// is missing, as the format has it), then nrows x ncols decimal numbers from the top row down, separated by white
/// space; line ends do not matter as long as the count is right. Throws input_error for a header without size, a
/// word that is no number, and too few or too many numbers, naming the first line whose count is not ncols.
class AscGrid : public SampleSource {
 public:
  explicit AscGrid(const std::string& path);
  int width() const override { return width_; }
  int height() const override { return height_; }
  SampleKind kind() const override { return SampleKind::kDouble; }
  int strip_rows() const override { return 64; }
  void read_rows(int first, int last, void* target) override;
  const PlainFileFacts& facts() const { return facts_; }

 private:
  void read_header();
  void count_numbers();
  /// Next number of the current line, then of the next lines; false at the end of the file.
  bool next_number(double& value);
  bool next_line();
  [[noreturn]] void refuse(const std::string& what) const;

  std::string path_;
  std::ifstream file_;
  std::string line_;
  size_t at_ = 0;  ///< in line_
  uint64_t line_number_ = 0;
  int width_ = 0, height_ = 0;
  std::streamoff first_number_ = 0;  ///< where the first line of numbers starts
  uint64_t first_line_ = 0;          ///< its number, less one
  PlainFileFacts facts_;
};

}  // namespace cuesta
