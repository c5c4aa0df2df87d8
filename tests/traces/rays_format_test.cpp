#include "traces/rays_format.h"

#include <gtest/gtest.h>
#include <zstd.h>

#include <cmath>
#include <limits>

#include "tests/traces/support.h"
#include "traces/rays_reader.h"
#include "traces/rays_writer.h"

namespace cuesta {
namespace {

constexpr size_t kHeader = 64, kChunkHeader = 40;

/// A file built byte by byte from the README's tables, apart from the writer.
std::string little_endian(uint64_t value, int bytes) {
  std::string text;
  for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> (8 * k));
  return text;
}

std::string sealed(std::string header) {
  const std::span<const uint8_t> bytes(reinterpret_cast<const uint8_t*>(header.data()), header.size());
  return header + little_endian(rays_format::checksum(bytes), 8);
}

std::string file_header(uint32_t version, uint64_t chunk_rays, uint64_t rays, uint64_t chunks, uint64_t width,
                        uint64_t height) {
  return sealed("\x89RAYS\r\n\x1a" + little_endian(version, 4) + little_endian(64, 4) +
                little_endian(112, 4) + little_endian(chunk_rays, 4) + little_endian(rays, 8) +
                little_endian(chunks, 8) + little_endian(width, 4) + little_endian(height, 4) +
                little_endian(0, 8));
}

std::string chunk(uint64_t index, const std::string& records) {
  std::string stored(ZSTD_compressBound(records.size()), '\0');
  stored.resize(ZSTD_compress(stored.data(), stored.size(), records.data(), records.size(), 1));
  const std::span<const uint8_t> bytes(reinterpret_cast<const uint8_t*>(stored.data()), stored.size());
  return sealed("CHNK" + little_endian(records.size() / 112, 4) + little_endian(index, 8) +
                little_endian(stored.size(), 4) + little_endian(0, 4) +
                little_endian(rays_format::checksum(bytes), 8)) +
         stored;
}

std::string f64(double value) { return little_endian(std::bit_cast<uint64_t>(value), 8); }
std::string f32(float value) { return little_endian(std::bit_cast<uint32_t>(value), 4); }

std::string record(uint64_t id, double origin_u = 0.25, double direction_z = -1, double t_min = 0.125) {
  return little_endian(id, 8) + f64(origin_u) + f64(-2) + f64(1) + f64(0) + f64(0) + f64(direction_z) +
         f64(t_min) + f64(8) + little_endian(41, 8) + little_endian(3, 4) + little_endian(1, 4) +
         little_endian(-7ull, 4) + f32(0.5f) + f32(1.5f) + f32(-2.5f) + f32(3.5f) + little_endian(513, 2) +
         little_endian(2, 1) + little_endian(3, 1);
}

TEST(RaysFormat, ReaderTakesAFileBuiltFromTheDocumentedTables) {
  ScratchFolder folder;
  const std::string path = folder.file("a.rays");
  write_bytes(path, file_header(1, 2, 3, 2, 4, 2) + chunk(0, record(7) + record(9)) + chunk(1, record(8)));
  const RayTrace trace = read_rays(path);
  EXPECT_EQ(trace.width, 4);
  EXPECT_EQ(trace.height, 2);
  ASSERT_EQ(trace.rays.size(), 3u);
  EXPECT_EQ(trace.rays[0].id, 7u);
  EXPECT_EQ(trace.rays[2].id, 8u);
  const TracedRay& ray = trace.rays[1];
  EXPECT_EQ(ray.id, 9u);
  EXPECT_EQ(ray.origin[0], 0.25);
  EXPECT_EQ(ray.origin[1], -2);
  EXPECT_EQ(ray.origin[2], 1);
  EXPECT_EQ(ray.direction[2], -1);
  EXPECT_EQ(ray.t_min, 0.125);
  EXPECT_EQ(ray.t_max, 8);
  EXPECT_EQ(ray.parent, 41u);
  EXPECT_EQ(ray.pixel_x, 3u);
  EXPECT_EQ(ray.pixel_y, 1u);
  EXPECT_EQ(ray.fixed_coordinate, -7);
  EXPECT_EQ(ray.gradient[0], 0.5f);
  EXPECT_EQ(ray.gradient[3], 3.5f);
  EXPECT_EQ(ray.light, 513);
  EXPECT_EQ(ray.kind, RayKind::kReflection);
  EXPECT_EQ(ray.fixed_axis, FixedAxis::kZ);
}

TEST(RaysFormat, EveryFieldComesBackBitForBit) {
  ScratchFolder folder;
  for (size_t count : {size_t{0}, size_t{1}, size_t{4095}, size_t{4096}, size_t{4097}, size_t{20000}}) {
    const RayTrace trace = any_trace(count + 1, count);
    write_rays(folder.file("a.rays"), trace);
    EXPECT_TRUE(identical(trace, read_rays(folder.file("a.rays")))) << count;
    const RaySummary summary = check_rays(folder.file("a.rays"));
    EXPECT_EQ(summary.rays, count);
    EXPECT_EQ(summary.chunks, (count + 4095) / 4096);
    EXPECT_EQ(summary.of_kind[0] + summary.of_kind[1] + summary.of_kind[2] + summary.of_kind[3], count);
    EXPECT_EQ(summary.descending + summary.horizontal + summary.rising, count);
  }
  EXPECT_EQ(folder.files(), 1u);
}

TEST(RaysFormat, EveryFlippedBitIsAnErrorOrTheSameRays) {
  ScratchFolder folder;
  const std::string path = folder.file("a.rays");
  const RayTrace trace = any_trace(5, 3);
  write_rays(path, trace);
  const std::string good = bytes_of(path);
  int refused = 0;
  for (size_t at = 0; at < good.size() * 8; ++at) {
    std::string bad = good;
    bad[at / 8] = static_cast<char>(bad[at / 8] ^ (1 << at % 8));
    write_bytes(path, bad);
    try {
      EXPECT_TRUE(identical(trace, read_rays(path))) << "bit " << at;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::kInput);
      ++refused;
    }
  }
  EXPECT_EQ(refused, static_cast<int>(good.size() * 8));  // every byte is under a checksum
}

TEST(RaysFormat, EveryTruncationIsAnError) {
  ScratchFolder folder;
  const std::string path = folder.file("a.rays");
  write_bytes(path, file_header(1, 2, 3, 2, 4, 2) + chunk(0, record(7) + record(9)) + chunk(1, record(8)));
  const std::string good = bytes_of(path);
  for (size_t size = 0; size < good.size(); ++size) {
    write_bytes(path, good.substr(0, size));
    const std::string sentence = sentence_of(ExitCode::kInput, [&] { read_rays(path); });
    EXPECT_TRUE(size < kHeader + 2 * kChunkHeader || sentence.find("chunk ") != std::string::npos)
        << sentence;
  }
}

TEST(RaysFormat, DamageIsNamedByChunkAndRay) {
  ScratchFolder folder;
  const std::string path = folder.file("a.rays");
  const auto sentence = [&](const std::string& bytes) {
    write_bytes(path, bytes);
    return sentence_of(ExitCode::kInput, [&] { check_rays(path); });
  };
  const auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const std::string first = chunk(0, record(7) + record(9));
  const std::string header = file_header(1, 2, 3, 2, 4, 2);
  expect(sentence(""), "empty");
  expect(sentence("id,origin_u"), "header");
  expect(sentence(std::string(200, 'x')), "not a .rays file");
  expect(sentence(file_header(2, 2, 3, 2, 4, 2) + first + chunk(1, record(8))), "version 2");
  expect(sentence(file_header(1, 2, 3, 1, 4, 2) + first), "contradict");
  expect(sentence(file_header(1, 0, 3, 1, 4, 2) + first), "0 rays per chunk");
  expect(sentence(file_header(1, 2, 3, 2, 0, 2) + first), "grid of 0 x 2");
  expect(sentence(file_header(1, 1, 1ull << 60, 1ull << 60, 4, 2) + first), "truncated");
  expect(sentence(header + first + chunk(1, record(8)) + "x"), "1 bytes follow");
  expect(sentence(header + first + chunk(2, record(8))), "chunk 1 of 2 is out of place");
  expect(sentence(header + first + first), "chunk 1 of 2 is out of place");
  expect(sentence(header + first + chunk(1, record(8) + record(6))), "chunk 1 of 2 states 2 rays");
  expect(sentence(header + first + chunk(1, record(7))), "id 7");
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  expect(sentence(header + first + chunk(1, record(8, nan))),
         "chunk 1 of 2 holds a damaged ray, ray 2 (id 8)");
  expect(sentence(header + chunk(0, record(7) + record(9, infinity))),
         "chunk 0 of 2 holds a damaged ray, ray 1");
  expect(sentence(header + first + chunk(1, record(8, 0, 0))), "its direction is zero");
  expect(sentence(header + first + chunk(1, record(8, 0, -infinity))), "direction's z");
  expect(sentence(header + first + chunk(1, record(8, 0, -1, -1))), "t_min");
  EXPECT_NE(sentence_of(ExitCode::kInput, [&] { read_rays(folder.file("missing")); }).find("no such file"),
            std::string::npos);
  EXPECT_NE(sentence_of(ExitCode::kInput, [&] { read_rays(folder.file("")); }).find("regular"),
            std::string::npos);
}

TEST(RaysFormat, AZstdFrameOfTheWrongLengthIsAnError) {
  ScratchFolder folder;
  const std::string path = folder.file("a.rays");
  std::string two = chunk(0, record(7) + record(9));
  two.replace(4, 4, little_endian(1, 4));  // claims one ray, holds two
  write_bytes(path, file_header(1, 2, 1, 1, 4, 2) + sealed(two.substr(0, 32)) + two.substr(40));
  EXPECT_NE(sentence_of(ExitCode::kInput, [&] { read_rays(path); }).find("decompress"), std::string::npos);
}

TEST(RaysFormat, AFailedWriteLeavesTheOldFileAndNothingElse) {
  ScratchFolder folder;
  const std::string path = folder.file("a.rays");
  write_bytes(path, "old");
  RayTrace trace = any_trace(5, 5000);
  trace.rays[4999].origin[1] = std::nan("");
  sentence_of(ExitCode::kInput, [&] { write_rays(path, trace); });
  trace.rays[4999] = trace.rays[0];
  sentence_of(ExitCode::kInput, [&] { write_rays(path, trace); });
  EXPECT_EQ(bytes_of(path), "old");
  EXPECT_EQ(folder.files(), 1u);
  sentence_of(ExitCode::kResource, [&] { write_rays(folder.file("no/folder.rays"), any_trace(1, 1)); });
}

TEST(RaysFormat, SameRaysGiveTheSameBytes) {
  ScratchFolder folder;
  write_rays(folder.file("a"), any_trace(5, 9000));
  write_rays(folder.file("b"), any_trace(5, 9000));
  EXPECT_EQ(bytes_of(folder.file("a")), bytes_of(folder.file("b")));
}

}  // namespace
}  // namespace cuesta
