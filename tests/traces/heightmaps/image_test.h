#pragma once

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "tests/traces/heightmaps/image_bytes.h"
#include "traces/heightmaps/image_reader.h"

namespace cuesta::test {

/// A folder of its own for the files of one test.
class ImageTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("cuesta_images_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const Bytes& bytes) const {
    write_bytes(path(name), bytes);
    return path(name);
  }

  /// Writes interleaved samples of type T through OpenImageIO.
  template <typename T>
  std::string write_image(const std::string& name, int width, int height, std::vector<std::string> channels,
                          OIIO::TypeDesc type, const std::vector<T>& samples,
                          OIIO::TypeDesc stored = {}) const {
    OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()),
                         stored == OIIO::TypeDesc() ? type : stored);
    spec.channelnames = channels;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.alpha_channel = channels.back() == "A" ? static_cast<int>(channels.size()) - 1 : -1;
    auto output = OIIO::ImageOutput::create(path(name));
    EXPECT_TRUE(output && output->open(path(name), spec) && output->write_image(type, samples.data()) &&
                output->close())
        << name;
    return path(name);
  }

  std::filesystem::path folder_;
};

inline HeightSource source(const std::string& path, const std::string& channel = "") {
  HeightSource from;
  from.path = path;
  from.channel = channel;
  return from;
}

inline HeightSource range(const std::string& path, double low, double high, int bits = 0) {
  HeightSource from;
  from.path = path;
  from.bits = bits;
  from.normalisation = Normalisation::kRange;
  from.low = low;
  from.high = high;
  return from;
}

/// The sentence of the error, which must have the given code and end as a sentence does.
inline std::string error_of(const HeightSource& from, ExitCode code = ExitCode::kInput) {
  try {
    load_heights(from);
  } catch (const Error& error) {
    std::string sentence = error.what();
    EXPECT_EQ(error.code(), code) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    EXPECT_TRUE(sentence.ends_with('.')) << sentence;
    return sentence;
  }
  ADD_FAILURE() << from.path << " was accepted";
  return "";
}

using Heights = std::vector<uint16_t>;

}  // namespace cuesta::test
