#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "traces/ray_trace.h"

namespace cuesta {

/// Reads a `.rays` file chunk by chunk. Whatever the bytes are, the outcome is the rays that were written or an
/// input_error that says what is wrong and in which chunk; memory stays in proportion to the file's size.
class RayReader {
 public:
  /// Reads and checks the header: magic, version, checksum, sizes that fit the file.
  explicit RayReader(const std::string& path);

  int width() const { return width_; }
  int height() const { return height_; }
  uint64_t ray_count() const { return ray_count_; }
  uint64_t chunk_count() const { return chunk_count_; }
  uint64_t file_bytes() const { return file_bytes_; }

  /// Appends the next chunk's rays; false after the last, when the file must be at its end. Throws input_error
  /// naming the chunk, and the ray by its number in the file, for damaged bytes or a damaged ray.
  bool next_chunk(std::vector<TracedRay>& rays);

 private:
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_in_chunk(const std::string& what) const;
  void read(void* bytes, size_t size);

  std::string path_;
  std::ifstream file_;
  uint64_t file_bytes_ = 0, position_ = 0;
  int width_ = 0, height_ = 0;
  uint32_t chunk_rays_ = 0;
  uint64_t ray_count_ = 0, chunk_count_ = 0;
  uint64_t chunk_ = 0, rays_read_ = 0;
  std::vector<uint8_t> stored_, records_;
};

/// The whole trace. Throws input_error for what RayReader refuses and for two rays with one id; Error(kResource)
/// when memory does not suffice; Error(kIncomplete) when `watch` says stop.
RayTrace read_rays(const std::string& path, const RayWatch& watch = {});

/// How steep a ray is: |z| of its direction over the larger of |u| and |v|, in heights of the slab per tile.
/// 0: vertical, 1: 10 and more, then a class per decade, 8: below 1e-5, 9: horizontal.
inline constexpr int kSlopeClasses = 10;
int slope_class(const TracedRay& ray);
/// "10 and more".
std::string_view name_of_slope_class(int slope_class);

/// What a trace holds.
struct RaySummary {
  int width = 0, height = 0;
  uint64_t rays = 0, chunks = 0, file_bytes = 0;
  uint64_t of_kind[4] = {0, 0, 0, 0};  ///< by RayKind
  uint64_t descending = 0, horizontal = 0, rising = 0;
  uint64_t of_slope[kSlopeClasses] = {};           ///< by slope_class
  uint64_t pixels = 0;                             ///< pixels that at least one ray belongs to
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};  ///< bounds of the origins; zeros without rays
};

/// Reads the file to its end, one chunk in memory at a time. Throws as read_rays.
RaySummary check_rays(const std::string& path);

/// The same figures of a trace in memory; chunks and file_bytes are 0.
RaySummary summarise(const RayTrace& trace);

}  // namespace cuesta
