#include "traces/rays_format.h"

#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <type_traits>

namespace cuesta::rays_format {
namespace {

template <typename T>
using BitsOf = std::conditional_t<
    sizeof(T) == 8, uint64_t,
    std::conditional_t<sizeof(T) == 4, uint32_t, std::conditional_t<sizeof(T) == 2, uint16_t, uint8_t>>>;

/// Little-endian bytes of values, one after the other.
class ByteSink {
 public:
  explicit ByteSink(uint8_t* bytes) : next_(bytes) {}
  template <typename T>
  void put(T value) {
    const auto bits = std::bit_cast<BitsOf<T>>(value);
    for (size_t k = 0; k < sizeof(T); ++k) *next_++ = static_cast<uint8_t>(bits >> (8 * k));
  }
  void put_bytes(std::span<const uint8_t> bytes) { next_ = std::copy(bytes.begin(), bytes.end(), next_); }

 private:
  uint8_t* next_;
};

class ByteSource {
 public:
  explicit ByteSource(const uint8_t* bytes) : next_(bytes) {}
  template <typename T>
  void get(T& value) {
    uint64_t bits = 0;
    for (size_t k = 0; k < sizeof(T); ++k) bits |= static_cast<uint64_t>(*next_++) << (8 * k);
    value = std::bit_cast<T>(static_cast<BitsOf<T>>(bits));
  }
  void skip(size_t bytes) { next_ += bytes; }

 private:
  const uint8_t* next_;
};

}  // namespace

uint64_t checksum(std::span<const uint8_t> bytes) { return XXH64(bytes.data(), bytes.size(), 0); }

bool checksum_holds(std::span<const uint8_t> header_bytes) {
  const size_t covered = header_bytes.size() - 8;
  uint64_t stored = 0;
  ByteSource(header_bytes.data() + covered).get(stored);
  return stored == checksum(header_bytes.first(covered));
}

bool has_magic(std::span<const uint8_t, kHeaderBytes> bytes) {
  return std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

bool has_magic(std::span<const uint8_t, kChunkHeaderBytes> bytes) {
  return std::equal(kChunkMagic.begin(), kChunkMagic.end(), bytes.begin());
}

HeaderBytes encode(const FileHeader& header) {
  HeaderBytes bytes{};
  ByteSink sink(bytes.data());
  sink.put_bytes(kMagic);
  sink.put(header.version);
  sink.put(header.header_bytes);
  sink.put(header.record_bytes);
  sink.put(header.chunk_rays);
  sink.put(header.ray_count);
  sink.put(header.chunk_count);
  sink.put(header.width);
  sink.put(header.height);
  sink.put(uint64_t{0});
  sink.put(checksum(std::span(bytes).first(kHeaderBytes - 8)));
  return bytes;
}

FileHeader decode(std::span<const uint8_t, kHeaderBytes> bytes) {
  FileHeader header;
  ByteSource source(bytes.data());
  source.skip(kMagic.size());
  source.get(header.version);
  source.get(header.header_bytes);
  source.get(header.record_bytes);
  source.get(header.chunk_rays);
  source.get(header.ray_count);
  source.get(header.chunk_count);
  source.get(header.width);
  source.get(header.height);
  return header;
}

ChunkHeaderBytes encode(const ChunkHeader& header) {
  ChunkHeaderBytes bytes{};
  ByteSink sink(bytes.data());
  sink.put_bytes(kChunkMagic);
  sink.put(header.rays);
  sink.put(header.index);
  sink.put(header.stored_bytes);
  sink.put(uint32_t{0});
  sink.put(header.stored_checksum);
  sink.put(checksum(std::span(bytes).first(kChunkHeaderBytes - 8)));
  return bytes;
}

ChunkHeader decode(std::span<const uint8_t, kChunkHeaderBytes> bytes) {
  ChunkHeader header;
  ByteSource source(bytes.data());
  source.skip(kChunkMagic.size());
  source.get(header.rays);
  source.get(header.index);
  source.get(header.stored_bytes);
  source.skip(4);
  source.get(header.stored_checksum);
  return header;
}

void encode_record(const TracedRay& ray, uint8_t* bytes) {
  ByteSink sink(bytes);
  sink.put(ray.id);
  for (double value : ray.origin) sink.put(value);
  for (double value : ray.direction) sink.put(value);
  sink.put(ray.t_min);
  sink.put(ray.t_max);
  sink.put(ray.parent);
  sink.put(ray.pixel_x);
  sink.put(ray.pixel_y);
  sink.put(ray.fixed_coordinate);
  for (float value : ray.gradient) sink.put(value);
  sink.put(ray.light);
  sink.put(static_cast<uint8_t>(ray.kind));
  sink.put(static_cast<uint8_t>(ray.fixed_axis));
}

TracedRay decode_record(const uint8_t* bytes) {
  TracedRay ray;
  uint8_t kind = 0, fixed_axis = 0;
  ByteSource source(bytes);
  source.get(ray.id);
  for (double& value : ray.origin) source.get(value);
  for (double& value : ray.direction) source.get(value);
  source.get(ray.t_min);
  source.get(ray.t_max);
  source.get(ray.parent);
  source.get(ray.pixel_x);
  source.get(ray.pixel_y);
  source.get(ray.fixed_coordinate);
  for (float& value : ray.gradient) source.get(value);
  source.get(ray.light);
  source.get(kind);
  source.get(fixed_axis);
  ray.kind = static_cast<RayKind>(kind);
  ray.fixed_axis = static_cast<FixedAxis>(fixed_axis);
  return ray;
}

}  // namespace cuesta::rays_format
