#include <OpenImageIO/imageio.h>

#include "models/files/image_codec.h"

// The one source that links OpenImageIO: the module cuesta_images.so.

namespace cuesta {
namespace {

struct Kind {
  OIIO::TypeDesc::BASETYPE base;
  SampleKind kind;
};

constexpr Kind kKinds[] = {
    {OIIO::TypeDesc::UINT8, SampleKind::kUint8},   {OIIO::TypeDesc::UINT16, SampleKind::kUint16},
    {OIIO::TypeDesc::UINT32, SampleKind::kUint32}, {OIIO::TypeDesc::INT8, SampleKind::kInt8},
    {OIIO::TypeDesc::INT16, SampleKind::kInt16},   {OIIO::TypeDesc::INT32, SampleKind::kInt32},
    {OIIO::TypeDesc::HALF, SampleKind::kHalf},     {OIIO::TypeDesc::FLOAT, SampleKind::kFloat},
    {OIIO::TypeDesc::DOUBLE, SampleKind::kDouble},
};

std::optional<SampleKind> kind_of(OIIO::TypeDesc type) {
  for (const Kind& row : kKinds) {
    if (row.base == type.basetype) return row.kind;
  }
  return std::nullopt;
}

/// In memory halves are floats.
OIIO::TypeDesc in_memory(SampleKind kind) {
  return kind == SampleKind::kHalf ? OIIO::TypeDesc::FLOAT : kKinds[static_cast<size_t>(kind)].base;
}

/// OpenImageIO's words, which are sometimes none.
std::string reason(const std::string& words) { return words.empty() ? "no reason given" : words; }

class OiioInput final : public ImageInput {
 public:
  explicit OiioInput(std::unique_ptr<OIIO::ImageInput> input)
      : input_(std::move(input)), spec_(input_->spec()) {
    header_.format = input_->format_name();
    header_.width = spec_.width;
    header_.height = spec_.height;
    header_.depth = spec_.depth;
    header_.deep = spec_.deep;
    header_.full_width = spec_.full_width;
    header_.full_height = spec_.full_height;
    header_.channels = spec_.channelnames;
    for (int c = 0; c < spec_.nchannels; ++c) header_.kinds.push_back(kind_of(spec_.channelformat(c)));
    header_.widest = kind_of(spec_.format);
    header_.alpha_channel = spec_.alpha_channel;
    header_.tile_width = spec_.tile_width;
    header_.tile_height = spec_.tile_height;
    header_.image_bytes = spec_.image_bytes(true);
    header_.pixel_bytes = spec_.pixel_bytes(true);
    header_.orientation = spec_.get_int_attribute("Orientation", 1);
    header_.rows_per_strip = spec_.get_int_attribute("tiff:RowsPerStrip", spec_.height);
  }
  const ImageHeader& header() const override { return header_; }
  std::string look_for_more(bool& more) override {
    more = input_->seek_subimage(1, 0);
    if (!input_->seek_subimage(0, 0)) return reason(input_->geterror());
    input_->geterror();
    return "";
  }
  std::string read_rows(int first, int last, int channel, int count, SampleKind kind, void* target) override {
    const OIIO::TypeDesc type = in_memory(kind);
    const int top = spec_.y + first, bottom = spec_.y + last;
    const bool read =
        spec_.tile_width > 0
            ? input_->read_tiles(0, 0, spec_.x, spec_.x + spec_.width, top, bottom, spec_.z, spec_.z + 1,
                                 channel, channel + count, type, target)
            : input_->read_scanlines(0, 0, top, bottom, spec_.z, channel, channel + count, type, target);
    const std::string words = input_->geterror();
    return read ? "" : reason(words);
  }

 private:
  std::unique_ptr<OIIO::ImageInput> input_;
  OIIO::ImageSpec spec_;
  ImageHeader header_;
};

class OiioOutput final : public ImageOutput {
 public:
  OiioOutput(std::unique_ptr<OIIO::ImageOutput> output, OIIO::TypeDesc type)
      : output_(std::move(output)), type_(type) {}
  std::string write_row(int row, const void* samples) override {
    return output_->write_scanline(row, 0, type_, samples) ? "" : reason(output_->geterror());
  }
  std::string close() override { return output_->close() ? "" : reason(output_->geterror()); }

 private:
  std::unique_ptr<OIIO::ImageOutput> output_;
  OIIO::TypeDesc type_;
};

class OiioCodec final : public ImageCodec {
 public:
  std::unique_ptr<ImageInput> open(const std::string& path, std::string& fault) const override {
    OIIO::ImageSpec hints;
    hints.attribute("oiio:UnassociatedAlpha", 1);  // else R, G and B come back multiplied by alpha
    auto input = OIIO::ImageInput::open(path, &hints);
    if (input) return std::make_unique<OiioInput>(std::move(input));
    fault = reason(OIIO::geterror());
    return nullptr;
  }
  std::unique_ptr<ImageOutput> create(const std::string& path, const std::string& format,
                                      const ImageLayout& layout, std::string& fault) const override {
    auto output = OIIO::ImageOutput::create(format);
    if (!output) {
      fault = reason(OIIO::geterror());
      return nullptr;
    }
    const OIIO::TypeDesc type = in_memory(layout.kind);
    OIIO::ImageSpec spec(layout.width, layout.height, static_cast<int>(layout.channels.size()), type);
    spec.channelnames = layout.channels;
    // Else EXR and TIFF say when they were written; the same rows are to be the same bytes.
    if (format != "png") spec.attribute("DateTime", "1970:01:01 00:00:00");
    if (!layout.compression.empty()) spec.attribute("compression", layout.compression);
    if (!output->open(path, spec)) {
      fault = reason(output->geterror());
      return nullptr;
    }
    return std::make_unique<OiioOutput>(std::move(output), type);
  }
};

}  // namespace
}  // namespace cuesta

extern "C" [[gnu::visibility("default")]] const cuesta::ImageCodec* cuesta_image_codec(int version) {
  static const cuesta::OiioCodec codec;
  return version == cuesta::kImageCodecVersion ? &codec : nullptr;
}
