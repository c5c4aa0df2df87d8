#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "traces/ray_trace.h"

namespace cuesta {

/// Writes a `.rays` file ray by ray, holding one chunk in memory. The file appears under its name only when
/// `finish` has succeeded; until then it is `path.partial-PROCESS`, which the destructor removes.
class RayWriter {
 public:
  /// Throws input_error for a grid that the format does not hold, Error(kResource) where nothing can be written.
  RayWriter(const std::string& path, int width, int height);
  ~RayWriter();
  RayWriter(const RayWriter&) = delete;
  RayWriter& operator=(const RayWriter&) = delete;

  /// Throws input_error naming a ray that no reader would accept. That ids differ is the caller's duty.
  void add(const TracedRay& ray);

  /// Writes what is left and the header, renames; an existing file of that name is replaced as a whole.
  void finish();

 private:
  void write(const void* bytes, size_t size);
  void write_chunk();

  std::string path_, temporary_;
  std::ofstream file_;
  int width_, height_;
  uint64_t ray_count_ = 0, chunk_count_ = 0;
  std::vector<uint8_t> records_, stored_;
  bool finished_ = false;
};

/// Throws as RayWriter, input_error when two rays share an id, and Error(kIncomplete) when `watch` says stop.
void write_rays(const std::string& path, const RayTrace& trace, const RayWatch& watch = {});

}  // namespace cuesta
