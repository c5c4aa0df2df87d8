#include "sim/explore/precision/half_precision.h"

#include <algorithm>
#include <bit>

namespace cuesta {

int64_t in_half_precision(int64_t height, int64_t full_scale) {
  const int extra = std::max(static_cast<int>(std::bit_width(static_cast<uint64_t>(height))) - 11, 0);
  if (extra == 0) return height;
  const int64_t below = height >> extra << extra, rest = height - below, half = int64_t{1} << (extra - 1);
  const bool up = rest > half || (rest == half && (below >> extra & 1) != 0);
  const int64_t nearest = up ? below + (int64_t{1} << extra) : below;
  return nearest <= full_scale ? nearest : below;
}

}  // namespace cuesta
