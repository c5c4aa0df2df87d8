#pragma once

#include <fstream>
#include <string>

#include "traces/heightmaps/sample_source.h"

namespace cuesta {

/// What a file without a header holds: rows of numbers, from the top, without padding.
struct RawShape {
  int width = 0;   ///< 0: not given
  int height = 0;  ///< rows
  SampleKind numbers = SampleKind::kUint16;
  bool big_endian = false;
  bool given() const { return width > 0; }
};

/// "1024x1024", "1024x1024:uint16" or "1024x1024:int16:big". Throws usage_error for anything else; `origin` names
/// the option or key in the sentence.
RawShape parse_raw_shape(const std::string& text, const std::string& origin);

/// The number type of that name out of uint8, uint16, uint32, int16, int32, float, double; false when there is none.
bool find_raw_numbers(std::string_view name, SampleKind& kind);
/// "uint8, uint16, ..." for messages.
std::string raw_number_names();

/// True for the names of headerless files: .raw, .r8, .r16, .r32, .hgt, in any case.
bool has_raw_name(const std::string& path);

/// A headerless file. Its shape is `wanted`, or what its name says: WIDTHxHEIGHT somewhere in the name, with .r8
/// for uint8, .r16 for little-endian uint16, .r32 for little-endian float, and for .raw uint8 or little-endian
/// uint16, whichever its bytes fill; .hgt is a tile of SRTM, 1201 or 3601 big-endian int16 on a side, with -32768
/// where there is no data. Throws input_error when nothing says the shape, with what to give, and when the file
/// does not have exactly the bytes of its shape.
class RawFile : public SampleSource {
 public:
  RawFile(const std::string& path, const RawShape& wanted);
  int width() const override { return shape_.width; }
  int height() const override { return shape_.height; }
  SampleKind kind() const override { return shape_.numbers; }
  int strip_rows() const override { return 64; }
  void read_rows(int first, int last, void* target) override;
  const PlainFileFacts& facts() const { return facts_; }

 private:
  std::string path_;
  RawShape shape_;
  PlainFileFacts facts_;
  std::ifstream file_;
};

}  // namespace cuesta
