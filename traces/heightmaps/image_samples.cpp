#include "traces/heightmaps/image_samples.h"

#include <optional>

#include "models/common/error.h"
#include "models/common/words.h"
#include "traces/heightmaps/asc_grid.h"
#include "traces/heightmaps/channel_choice.h"
#include "traces/heightmaps/image_file.h"
#include "traces/heightmaps/tiff_tags.h"

namespace cuesta {
namespace {

/// One channel of an image.
class ImageSamples : public SampleSource {
 public:
  ImageSamples(std::unique_ptr<ImageFile> file, int channel) : file_(std::move(file)), channel_(channel) {
    const std::optional<SampleKind> kind = file_->kind(channel);
    if (kind) {
      kind_ = *kind;
      return;
    }
    throw input_error(
        "Channel " + file_->channels()[static_cast<size_t>(channel)] + " of the image \"" + file_->path() +
        "\" has numbers of an unknown type; integers of 8 to 32 bits, half, float and double are accepted.");
  }
  int width() const override { return file_->width(); }
  int height() const override { return file_->height(); }
  SampleKind kind() const override { return kind_; }
  int strip_rows() const override { return file_->strip_rows(); }
  void read_rows(int first, int last, void* target) override {
    file_->read_rows(first, last, channel_, 1, kind_, target);
  }

 private:
  std::unique_ptr<ImageFile> file_;
  int channel_;
  SampleKind kind_ = SampleKind::kUint8;
};

OpenedHeights open_plain(const HeightSource& source, std::unique_ptr<SampleSource> samples,
                         PlainFileFacts facts) {
  if (!source.channel.empty() && source.channel != "0") {
    throw usage_error("The file \"" + source.path + "\" has no channel " + printable(source.channel) +
                      "; its format has one channel without a name, which needs not be given.");
  }
  return {std::move(samples), std::move(facts), {"heights"}, "heights", "the only channel"};
}

OpenedHeights open_image(const HeightSource& source) {
  auto file = std::make_unique<ImageFile>(source.path);
  const ChannelChoice choice = choose_channel(*file, source.channel);
  OpenedHeights opened;
  opened.channels = file->channels();
  opened.channel = opened.channels[static_cast<size_t>(choice.index)];
  opened.channel_reason = choice.reason;
  opened.facts.format = file->format();
  opened.facts.notes = file->notes();
  if (opened.facts.format == "tiff") {
    const TiffTags tags = read_tiff_tags(source.path);
    opened.facts.has_nodata = tags.gdal_nodata.has_value();
    opened.facts.nodata = tags.gdal_nodata.value_or(0);
    opened.facts.nodata_reason = "the file's GDAL_NODATA tag";
    if (tags.photometric == 3) {
      opened.facts.notes.insert(
          opened.facts.notes.begin(),
          "The picture has a palette; the colours that it stands for are read, not the indices.");
    }
  }
  opened.samples = std::make_unique<ImageSamples>(std::move(file), choice.index);
  return opened;
}

}  // namespace

OpenedHeights open_heights(const HeightSource& source) {
  if (source.raw.given() || has_raw_name(source.path)) {
    auto file = std::make_unique<RawFile>(source.path, source.raw);
    PlainFileFacts facts = file->facts();
    return open_plain(source, std::move(file), std::move(facts));
  }
  if (has_asc_name(source.path)) {
    auto file = std::make_unique<AscGrid>(source.path);
    PlainFileFacts facts = file->facts();
    return open_plain(source, std::move(file), std::move(facts));
  }
  return open_image(source);
}

}  // namespace cuesta
