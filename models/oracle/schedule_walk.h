#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "models/algorithms/schedule.h"
#include "models/heightmap/height_grid.h"
#include "models/oracle/oracle.h"

namespace cuesta {

/// A second opinion on steps: a schedule walked in exact arithmetic, in which the cell is divided out of the time
/// at every step and a node's bound is searched among its texels. Slow; for small maps.
template <class Int>
class OracleScheduleWalk {
 public:
  /// `leaves`: the surface at the level at which the schedules stop.
  OracleScheduleWalk(const ExactRay<Int>& ray, const HeightGrid& grid, const OracleMap& leaves)
      : ray_(ray), grid_(grid), leaves_(leaves), shape_(leaves.shape) {}

  OracleHit<Int> walk(const Schedule& schedule) {
    OracleHit<Int> answer;
    const auto start = oracle_start(ray_, shape_);
    if (!start) return answer;
    now_ = *start;
    set_end(*start);
    int level = start_level(schedule.start);
    uint64_t steps = 0;
    bool crossed_before = false;
    int previous_crossing = -1;  // level of the step before, if that was a crossing
    while (!ended()) {
      ++steps;
      const Node node = node_here(level);
      if (level == leaves_.level) {
        answer = oracle_ask_cell(ray_, leaves_, *start, node.u, node.v);
        if (answer.hit) break;
      } else if (!skipped(node, node.bound)) {
        if (ray_.z.sign < 0) now_ = later(now_, ray_.z.reaches(node.bound));
        level = crossed_before                 ? level - 1
                : schedule.down == kDownCommon ? std::min(level - 1, common_level())
                                               : level - schedule.down;
        level = std::max(level, leaves_.level);
        previous_crossing = -1;
        continue;
      }
      now_ = node.t_out;
      crossed_before = true;
      const bool up = goes_up(schedule.up, node, level, previous_crossing == level);
      previous_crossing = level;
      if (up && level < shape_.root_level) ++level;
    }
    answer.visits = steps;
    return answer;
  }

 private:
  struct Node {
    OracleSpan u, v;
    int64_t bound = 0;
    ExactTime<Int> t_out;
  };

  bool ended() const {
    const bool left = shape_.address_mode == AddressMode::kBorder &&
                      (ray_.x.plane(shape_.width) <= now_ || ray_.y.plane(shape_.height) <= now_);
    return left || now_ >= ray_.t_max || (ray_.z.sign > 0 && ray_.z.reaches(leaves_.highest) <= now_);
  }

  Node node_here(int level) const {
    Node node;
    node.u = oracle_span(ray_.x.cell_at(now_), ray_.x.sign < 0, shape_.width, level, shape_.address_mode);
    node.v = oracle_span(ray_.y.cell_at(now_), ray_.y.sign < 0, shape_.height, level, shape_.address_mode);
    for (int j = node.v.stored << level; j < std::min((node.v.stored + 1) << level, shape_.height); ++j) {
      for (int i = node.u.stored << level; i < std::min((node.u.stored + 1) << level, shape_.width); ++i) {
        node.bound = std::max<int64_t>(node.bound, grid_.at(i, j));
      }
    }
    if (level == leaves_.level) {  // all that a ray learns of a leaf is its mean
      node.bound = leaves_.values[static_cast<size_t>(node.v.stored) * leaves_.width + node.u.stored];
    }
    node.t_out = earlier(ray_.x.plane(node.u.upper), ray_.y.plane(node.v.upper));
    return node;
  }

  bool skipped(const Node& node, int64_t bound) const {
    const ExactTime<Int> reached = ray_.z.reaches(bound);
    return ray_.z.sign > 0 ? reached <= now_ : later(now_, reached) >= node.t_out;
  }

  int64_t tile_of(int64_t mirrored_leaf, int size) const {
    return shape_.address_mode == AddressMode::kClamp ? 0 : floor_divide<int64_t>(mirrored_leaf, size);
  }

  /// The leaf's index in its tile as a flipped tile counts: from the far end of 2^n leaves.
  int64_t local_leaf(int64_t mirrored_leaf, bool mirrored, int size) const {
    const int64_t tile = tile_of(mirrored_leaf, size);
    const bool turned = shape_.address_mode == AddressMode::kMirror && tile % 2 != 0;
    const int64_t local = mirrored_leaf - tile * size;
    return mirrored != turned ? local + (int64_t{1} << shape_.root_level) - size : local;
  }

  int start_level(StartRule rule) const {
    switch (rule) {
      case StartRule::kRoot:
        return shape_.root_level;
      case StartRule::kLeaf:
        return leaves_.level;
      case StartRule::kSpan:
        break;
    }
    return std::max(leaves_.level, common_level());
  }

  void set_end(const ExactTime<Int>& start) {
    end_ = ray_.t_max;
    if (ray_.z.sign < 0) end_ = earlier(end_, ray_.z.reaches(0));
    if (ray_.z.sign > 0) end_ = earlier(end_, ray_.z.reaches(leaves_.highest));
    end_ = later(end_, start);
  }

  /// Of the smallest node that holds the cell at `now_` and the cell at `end_`.
  int common_level() const {
    int64_t differ = 0;
    const auto axis_span = [&](const ExactAxis<Int>& axis, int size) {
      const int64_t first = axis.cell_at(now_);
      int64_t last = axis.cell_at(end_);
      if (shape_.address_mode == AddressMode::kBorder) last = std::min<int64_t>(last, size - 1);
      if (tile_of(first, size) != tile_of(last, size)) return false;
      differ |= local_leaf(first, axis.sign < 0, size) ^ local_leaf(last, axis.sign < 0, size);
      return true;
    };
    if (!axis_span(ray_.x, shape_.width) || !axis_span(ray_.y, shape_.height)) return shape_.root_level;
    return std::min(shape_.root_level, static_cast<int>(std::bit_width(static_cast<uint64_t>(differ))));
  }

  /// Asked after the crossing of `node`, now at its t_out.
  bool goes_up(UpRule rule, const Node& node, int level, bool crossed_here_before) const {
    const bool crossed_x = ray_.x.plane(node.u.upper) == now_, crossed_y = ray_.y.plane(node.v.upper) == now_;
    if (!now_.is_finite()) return false;
    const int64_t i = local_leaf(ray_.x.cell_at(now_), ray_.x.sign < 0, shape_.width) >> level;
    const int64_t j = local_leaf(ray_.y.cell_at(now_), ray_.y.sign < 0, shape_.height) >> level;
    const bool even_axis = (crossed_x && i % 2 == 0) || (crossed_y && j % 2 == 0);
    const auto selective = [&] { return ray_.z.sign > 0 || skipped(node_here(level), node.bound); };
    switch (rule) {
      case UpRule::kNever:
        return false;
      case UpRule::kAlways:
        return true;
      case UpRule::kInterval:
        return level % 2 == 0;
      case UpRule::kEvenAxis:
        return even_axis;
      case UpRule::kBothEven:
        return i % 2 == 0 && j % 2 == 0;
      case UpRule::kSelective:
        return selective();
      case UpRule::kSelectiveEven:
        return even_axis && selective();
      case UpRule::kCoherent:
        return crossed_here_before;
    }
    return false;
  }

  ExactRay<Int> ray_;
  const HeightGrid& grid_;
  OracleMap leaves_;
  MapShape shape_;
  ExactTime<Int> now_, end_;
};

}  // namespace cuesta
