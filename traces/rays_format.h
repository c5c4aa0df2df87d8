#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "models/rays/traced_ray.h"

/// The bytes of a `.rays` file, version 1; README.md in this folder is the format's definition for others.
/// Everything is little-endian. file = file header, then chunks; chunk = chunk header, then one zstd frame that
/// holds `rays` records.
namespace cuesta::rays_format {

inline constexpr std::array<uint8_t, 8> kMagic = {0x89, 'R', 'A', 'Y', 'S', 0x0D, 0x0A, 0x1A};
inline constexpr std::array<uint8_t, 4> kChunkMagic = {'C', 'H', 'N', 'K'};
inline constexpr uint32_t kVersion = 1;
inline constexpr size_t kHeaderBytes = 64;
inline constexpr size_t kChunkHeaderBytes = 40;
inline constexpr size_t kRecordBytes = 112;
inline constexpr uint32_t kChunkRays = 4096;       ///< what our writer uses
inline constexpr uint32_t kMostChunkRays = 65536;  ///< what a reader accepts

struct FileHeader {
  uint32_t version = kVersion;
  uint32_t header_bytes = kHeaderBytes;
  uint32_t record_bytes = kRecordBytes;
  uint32_t chunk_rays = kChunkRays;  ///< records in each chunk but the last
  uint64_t ray_count = 0;
  uint64_t chunk_count = 0;  ///< ceil(ray_count / chunk_rays)
  uint32_t width = 0;
  uint32_t height = 0;
};

struct ChunkHeader {
  uint32_t rays = 0;
  uint64_t index = 0;
  uint32_t stored_bytes = 0;     ///< of the zstd frame
  uint64_t stored_checksum = 0;  ///< XXH64, seed 0, of the zstd frame
};

using HeaderBytes = std::array<uint8_t, kHeaderBytes>;
using ChunkHeaderBytes = std::array<uint8_t, kChunkHeaderBytes>;

/// With magic and checksum.
HeaderBytes encode(const FileHeader& header);
ChunkHeaderBytes encode(const ChunkHeader& header);

bool has_magic(std::span<const uint8_t, kHeaderBytes> bytes);
bool has_magic(std::span<const uint8_t, kChunkHeaderBytes> bytes);
/// The last 8 bytes are the XXH64 of those before.
bool checksum_holds(std::span<const uint8_t> header_bytes);
FileHeader decode(std::span<const uint8_t, kHeaderBytes> bytes);
ChunkHeader decode(std::span<const uint8_t, kChunkHeaderBytes> bytes);

void encode_record(const TracedRay& ray, uint8_t* bytes);
TracedRay decode_record(const uint8_t* bytes);

uint64_t checksum(std::span<const uint8_t> bytes);

}  // namespace cuesta::rays_format
