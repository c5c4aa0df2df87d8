#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "models/common/error.h"
#include "models/common/random.h"
#include "models/rays/map_shape.h"
#include "traces/front_end.h"
#include "traces/ray_trace.h"

namespace cuesta {

/// A folder of its own for a test, removed with all it holds.
class ScratchFolder {
 public:
  ScratchFolder() {
    path_ = std::filesystem::temp_directory_path() /
            ("cuesta-traces-" + std::to_string(getpid()) + "-" + std::to_string(count()++));
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  size_t files() const {
    return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  static int& count() {
    static int count = 0;
    return count;
  }
  std::filesystem::path path_;
};

/// A map of 8 bits.
inline MapShape shape_of(int width, int height, AddressMode mode = AddressMode::kWrap) {
  return map_shape(width, height, 8, mode);
}

inline RayTrace make_rays(const Scene& scene, int width, int height, const std::optional<Crop>& crop = {}) {
  return make_rays(scene, shape_of(width, height, scene.address_mode), crop);
}

inline std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// The sentence of the Error that `act` throws with this exit code; fails the test when it throws none.
template <typename Act>
std::string sentence_of(ExitCode code, const Act& act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

/// Any finite double, subnormals and zeros of both signs included.
inline double any_double(Random& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random.chance(0.1)   ? random.next() & 0x800FFFFFFFFFFFFFull
                                               : random.chance(0.1) ? random.next() & (1ull << 63)
                                                                    : random.next());
    if (value - value == 0) return value;
  }
}

/// Rays that use every field over its whole range.
inline RayTrace any_trace(uint64_t seed, size_t count, int width = 300, int height = 7) {
  Random random(seed);
  RayTrace trace{width, height, {}};
  for (size_t k = 0; k < count; ++k) {
    TracedRay ray;
    ray.id = random.next();
    for (double& value : ray.origin) value = any_double(random);
    for (double& value : ray.direction) value = any_double(random);
    if (ray.direction[0] == 0) ray.direction[0] = 0x1p-1074;
    ray.t_min = std::bit_cast<double>(std::bit_cast<uint64_t>(any_double(random)) & ~(1ull << 63));
    if (random.chance(0.5)) ray.t_max = ray.t_min * 2;
    ray.pixel_x = static_cast<uint32_t>(random.below(static_cast<uint64_t>(width)));
    ray.pixel_y = static_cast<uint32_t>(random.below(static_cast<uint64_t>(height)));
    ray.kind = static_cast<RayKind>(random.below(4));
    ray.fixed_axis = static_cast<FixedAxis>(random.below(4));
    ray.light = static_cast<uint16_t>(random.next());
    ray.fixed_coordinate = static_cast<int32_t>(random.next());
    if (random.chance(0.5)) ray.parent = random.next();
    for (float& value : ray.gradient) value = static_cast<float>(random.unit() - 0.5);
    trace.rays.push_back(ray);
  }
  return trace;
}

}  // namespace cuesta
