#include <algorithm>

#include "models/common/error.h"
#include "tests/fuzz/scratch_file.h"
#include "traces/heightmaps/image_reader.h"

namespace cuesta::fuzz {
namespace {

struct Ending {
  std::string_view first_bytes;
  const char* name;
};

constexpr Ending kEndings[] = {
    {"\x89PNG", "in.png"}, {"II*", "in.tif"},      {"MM", "in.tif"},    {"\x76\x2f\x31\x01", "in.exr"},
    {"BM", "in.bmp"},      {"\xff\xd8", "in.jpg"}, {"DDS ", "in.dds"},  {"#?RADIANCE", "in.hdr"},
    {"P", "in.pnm"},       {"raw ", "in.raw"},     {"ncols", "in.asc"}, {"?", "in.unknown"}};

/// A TGA has no bytes of its own at its head: what is nothing else is one.
const char* name_for(Bytes bytes) {
  const std::string head = text_of(bytes.first(std::min<size_t>(bytes.size(), 16)));
  for (const Ending& ending : kEndings) {
    if (head.starts_with(ending.first_bytes)) return ending.name;
  }
  return "in.tga";
}

void read(const HeightSource& source) {
  try {
    const HeightGrid grid = load_heights(source).grid;
    require(grid.width > 0 && grid.height > 0 &&
                grid.texels.size() == static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height) &&
                *std::max_element(grid.texels.begin(), grid.texels.end()) <= grid.full_scale(),
            "heights that are read fill their grid and lie within full scale");
  } catch (const Error&) {
  }
}

}  // namespace
}  // namespace cuesta::fuzz

void cuesta::fuzz::image(Bytes bytes) {
  HeightSource source;
  source.path = scratch_file(name_for(bytes), bytes);
  read(source);
  source.channel = "0";  // where the rule decides nothing, and for what normalisation meets
  source.normalisation = Normalisation::kMinMax;
  read(source);
}
