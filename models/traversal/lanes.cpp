#include "models/traversal/lanes.h"

#if defined(__x86_64__)
// GCC 12 takes the undefined lanes of its own intrinsics for a mistake.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>

#include <array>
#include <bit>

// Only the functions with this attribute hold AVX-512 code; what they call from headers stays plain.
#define CUESTA_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw")))

namespace cuesta {

namespace {

constexpr int kLanes = 8;

using Ray = RayState<FixedArithmetic, PlainAxis>;
using PlainWalk = Walk<FixedArithmetic, PlainAxis>;

struct alignas(64) Lane64 {
  int64_t at[kLanes] = {};
};

struct LanePlaneTime {
  Lane64 slope, offset, limit, shift;

  void set(int lane, const FixedArithmetic::PlaneTime& line) {
    slope.at[lane] = line.slope;
    offset.at[lane] = line.offset;
    limit.at[lane] = line.limit;
    shift.at[lane] = line.shift;
  }
};

/// Eight rays on their way: RayState, field by field.
struct Group {
  LanePlaneTime x, y, z;
  Lane64 node_x, node_y, flip_x, flip_y;
  Lane64 t_cur, t_start, t_max, t_root;
  Lane64 level, down, last_crossed, steps;
  uint32_t ray[kLanes] = {};
  __mmask8 active = 0;
  __mmask8 rising = 0;

  void set(int lane, uint32_t number, const Ray& state) {
    x.set(lane, state.x);
    y.set(lane, state.y);
    z.set(lane, state.z);
    node_x.at[lane] = state.gx.node;
    node_y.at[lane] = state.gy.node;
    flip_x.at[lane] = state.gx.flip;
    flip_y.at[lane] = state.gy.flip;
    t_cur.at[lane] = state.t_cur;
    t_start.at[lane] = state.t_start;
    t_max.at[lane] = state.t_max;
    t_root.at[lane] = state.t_root;
    level.at[lane] = state.level;
    down.at[lane] = state.down;
    last_crossed.at[lane] = state.last_crossed;
    steps.at[lane] = 0;
    ray[lane] = number;
    const auto bit = static_cast<__mmask8>(1u << lane);
    active = static_cast<__mmask8>(active | bit);
    rising = static_cast<__mmask8>(state.rising ? rising | bit : rising & ~bit);
  }
};

class LaneTraversal {
 public:
  LaneTraversal(const PlainWalk& walk, const Pyramid& pyramid, std::span<const MachineRay> rays,
                std::span<const uint32_t> order, std::span<HitRecord> hits, const LineRecorder* recorder)
      : walk_(walk), rays_(rays), order_(order), hits_(hits), recorder_(recorder) {
    const uint16_t* base = pyramid.level(0);
    texels_ = base;
    for (int level = 0; level <= pyramid.root_level(); ++level) {
      first_.at(static_cast<size_t>(level)) = pyramid.level(level) - base;
    }
    if (recorder != nullptr) {
      scratch_.resize(2 * kLanes * capacity_);
      blocks_ = recorder->layout->kind() == TexelLayoutKind::kBlocks4x4;
      const int rows = blocks_ ? 4 : 1;
      for (int level = 0; level <= pyramid.root_level(); ++level) {
        const auto l = static_cast<size_t>(level);
        line_base_.at(l) = static_cast<int64_t>(recorder->layout->offset(level, 0, 0));
        line_pitch_.at(l) =
            pyramid.height(level) > rows
                ? static_cast<int64_t>(recorder->layout->offset(level, 0, rows)) - line_base_.at(l)
                : 0;
      }
      texel_shift_ = recorder->layout->texel_bytes() == 1 ? 0 : recorder->layout->texel_bytes() == 2 ? 1 : 2;
    }
  }

  void run() {
    Group groups[2];
    for (Group& group : groups) {
      for (int lane = 0; lane < kLanes; ++lane) refill(group, lane);
    }
    while ((groups[0].active | groups[1].active) != 0) {
      step(groups[0], 0);
      step(groups[1], 1);
    }
  }

 private:
  /// Puts the next ray that has a step to do into the lane.
  void refill(Group& group, int lane) {
    group.active = static_cast<__mmask8>(group.active & ~(1u << lane));
    while (next_ < hits_.size()) {
      const uint32_t number = static_cast<uint32_t>(next_++);
      const MachineRay& input = rays_[order_.empty() ? number : order_[number]];
      Ray state;
      if (start(walk_, input, state) == Visit::kContinue) return group.set(lane, number, state);
      hits_[number] = hit_record(walk_, state, input.id, Visit::kMiss);
      if (recorder_ != nullptr) recorder_->spans[number] = {recorder_->lines->size(), 0};
    }
  }

  void grow_scratch() {
    std::vector<uint32_t> larger(scratch_.size() * 2);
    for (size_t lane = 0; lane < 2 * kLanes; ++lane) {
      std::copy_n(scratch_.begin() + static_cast<std::ptrdiff_t>(lane * capacity_), capacity_,
                  larger.begin() + static_cast<std::ptrdiff_t>(lane * capacity_ * 2));
    }
    scratch_ = std::move(larger);
    capacity_ *= 2;
  }

  void finish(Group& group, size_t first_lane, int lane, const HitRecord& record) {
    const uint32_t number = group.ray[lane];
    hits_[number] = record;
    if (recorder_ != nullptr) {
      const auto first = scratch_.begin() +
                         static_cast<std::ptrdiff_t>((first_lane + static_cast<size_t>(lane)) * capacity_);
      recorder_->spans[number] = {recorder_->lines->size(), record.steps};
      recorder_->lines->insert(recorder_->lines->end(), first, first + record.steps);
    }
    refill(group, lane);
  }

  CUESTA_AVX512 static inline __m512i load(const Lane64& value) { return _mm512_load_si512(value.at); }
  CUESTA_AVX512 static inline void store(Lane64& value, __m512i v) { _mm512_store_si512(value.at, v); }

  /// FixedArithmetic::at, lane by lane.
  CUESTA_AVX512 inline __m512i at(const LanePlaneTime& line, __m512i k) const {
    const __m512i p = _mm512_sub_epi64(_mm512_mul_epi32(k, load(line.slope)), load(line.offset));
    const __mmask8 over = _mm512_cmpgt_epi64_mask(p, load(line.limit));
    const __m512i shifted = _mm512_sllv_epi64(_mm512_max_epi64(p, _mm512_set1_epi64(-1)), load(line.shift));
    return _mm512_mask_mov_epi64(shifted, over, _mm512_set1_epi64(walk_.format.t_end));
  }

  CUESTA_AVX512 static inline __m512i exit_plane(__m512i node, __m512i level) {
    return _mm512_sllv_epi64(_mm512_add_epi64(node, _mm512_set1_epi64(1)), level);
  }
  CUESTA_AVX512 static inline __m512i middle_plane(__m512i node, __m512i level) {
    const __m512i twice = _mm512_add_epi64(_mm512_add_epi64(node, node), _mm512_set1_epi64(1));
    return _mm512_srai_epi64(_mm512_sllv_epi64(twice, level), 1);
  }

  CUESTA_AVX512 void record_lines(Group& group, size_t first_lane, __m512i level, __m512i x, __m512i y) {
    const __m512i steps = load(group.steps);
    if (_mm512_mask_cmpge_epi64_mask(group.active, steps,
                                     _mm512_set1_epi64(static_cast<int64_t>(capacity_)))) {
      grow_scratch();
    }
    if (blocks_) {  // the place in a row of blocks, and which row of blocks
      const __m512i low = _mm512_set1_epi64(3);
      const __m512i inside =
          _mm512_or_epi64(_mm512_slli_epi64(_mm512_and_epi64(y, low), 2), _mm512_and_epi64(x, low));
      x = _mm512_or_epi64(_mm512_slli_epi64(_mm512_srli_epi64(x, 2), 4), inside);
      y = _mm512_srli_epi64(y, 2);
    }
    const __m512i zero = _mm512_setzero_si512();
    const __m512i base = _mm512_mask_i64gather_epi64(zero, group.active, level, line_base_.data(), 8);
    const __m512i pitch = _mm512_mask_i64gather_epi64(zero, group.active, level, line_pitch_.data(), 8);
    const __m512i address = _mm512_add_epi64(_mm512_add_epi64(base, _mm512_mullo_epi64(y, pitch)),
                                             _mm512_sll_epi64(x, _mm_cvtsi32_si128(texel_shift_)));
    const __m512i line = _mm512_srl_epi64(address, _mm_cvtsi32_si128(recorder_->line_shift));
    const __m512i lane = _mm512_add_epi64(_mm512_set_epi64(7, 6, 5, 4, 3, 2, 1, 0),
                                          _mm512_set1_epi64(static_cast<int64_t>(first_lane)));
    const __m512i place =
        _mm512_add_epi64(_mm512_mullo_epi64(lane, _mm512_set1_epi64(static_cast<int64_t>(capacity_))), steps);
    _mm512_mask_i64scatter_epi32(scratch_.data(), group.active, place, _mm512_cvtepi64_epi32(line), 4);
  }

  /// `visit`, lane by lane.
  CUESTA_AVX512 void step(Group& g, int number) {
    const size_t first_lane = static_cast<size_t>(number) * kLanes;
    const __m512i one = _mm512_set1_epi64(1), zero = _mm512_setzero_si512();
    const int root_level = walk_.map.root_level;
    const __m512i stop = _mm512_set1_epi64(walk_.schedule.stop_level);
    const __m512i level = load(g.level);
    const __m512i node_x = load(g.node_x), node_y = load(g.node_y);
    const __mmask8 rising = g.rising;
    const auto falling = static_cast<__mmask8>(~rising);

    // Fetch.
    const __m512i side = _mm512_srlv_epi64(_mm512_set1_epi64((int64_t{1} << root_level) - 1), level);
    const __m512i fetch_x = _mm512_and_epi64(_mm512_xor_epi64(node_x, load(g.flip_x)), side);
    const __m512i fetch_y = _mm512_and_epi64(_mm512_xor_epi64(node_y, load(g.flip_y)), side);
    const __m512i row = _mm512_sllv_epi64(fetch_y, _mm512_sub_epi64(_mm512_set1_epi64(root_level), level));
    const __m512i index = _mm512_add_epi64(
        _mm512_add_epi64(row, fetch_x), _mm512_mask_i64gather_epi64(zero, g.active, level, first_.data(), 8));
    const __m256i pairs = _mm512_mask_i64gather_epi32(_mm256_setzero_si256(), g.active, index, texels_, 2);
    const __m512i bound = _mm512_and_epi64(_mm512_cvtepu32_epi64(pairs), _mm512_set1_epi64(0xFFFF));
    if (recorder_ != nullptr) record_lines(g, first_lane, level, fetch_x, fetch_y);
    const __m512i steps = _mm512_add_epi64(load(g.steps), one);
    store(g.steps, steps);

    const __m512i t_x = at(g.x, exit_plane(node_x, level));
    const __m512i t_y = at(g.y, exit_plane(node_y, level));
    const __m512i t_out = _mm512_min_epi64(t_x, t_y);
    const __m512i t_z = at(g.z, bound);
    const __m512i t_cur = load(g.t_cur), t_max = load(g.t_max);
    const __mmask8 leaf = _mm512_cmpeq_epi64_mask(level, stop);

    // The leaf's answer.
    const auto candidate =
        static_cast<__mmask8>(g.active & leaf & (rising | _mm512_cmplt_epi64_mask(t_z, t_out)));
    __mmask8 hit = 0;
    Lane64 in_x, in_y, t_hit, top;
    if (candidate != 0) {
      const __m512i enter_x = at(g.x, _mm512_sllv_epi64(node_x, level));
      const __m512i enter_y = at(g.y, _mm512_sllv_epi64(node_y, level));
      const __m512i t_in = _mm512_max_epi64(load(g.t_start), _mm512_max_epi64(enter_x, enter_y));
      const __m512i reach = _mm512_mask_max_epi64(t_in, falling, t_in, t_z);
      hit = static_cast<__mmask8>(candidate & _mm512_cmplt_epi64_mask(reach, _mm512_min_epi64(t_out, t_max)) &
                                  (falling | _mm512_cmplt_epi64_mask(t_in, t_z)));
      store(in_x, enter_x);
      store(in_y, enter_y);
      store(t_hit, reach);
      store(top,
            _mm512_maskz_mov_epi64(static_cast<__mmask8>(falling & _mm512_cmpge_epi64_mask(t_z, t_in)), one));
    }

    const __m512i reached = _mm512_mask_max_epi64(t_cur, falling, t_cur, t_z);
    const auto skip = static_cast<__mmask8>(leaf | (rising & _mm512_cmple_epi64_mask(t_z, t_cur)) |
                                            (falling & _mm512_cmpge_epi64_mask(reached, t_out)));
    const auto down = static_cast<__mmask8>(~skip);
    const auto cross_x = static_cast<__mmask8>(skip & _mm512_cmpeq_epi64_mask(t_x, t_out));
    const auto cross_y = static_cast<__mmask8>(skip & _mm512_cmpeq_epi64_mask(t_y, t_out));
    const auto upper_x =
        static_cast<__mmask8>(down & _mm512_cmple_epi64_mask(at(g.x, middle_plane(node_x, level)), reached));
    const auto upper_y =
        static_cast<__mmask8>(down & _mm512_cmple_epi64_mask(at(g.y, middle_plane(node_y, level)), reached));
    __m512i next_x = _mm512_mask_add_epi64(node_x, down, node_x, node_x);
    __m512i next_y = _mm512_mask_add_epi64(node_y, down, node_y, node_y);
    next_x = _mm512_mask_add_epi64(next_x, static_cast<__mmask8>(cross_x | upper_x), next_x, one);
    next_y = _mm512_mask_add_epi64(next_y, static_cast<__mmask8>(cross_y | upper_y), next_y, one);
    const __m512i t_next = _mm512_mask_mov_epi64(reached, skip, t_out);

    // Up.
    const __mmask8 even_x = _mm512_testn_epi64_mask(next_x, one),
                   even_y = _mm512_testn_epi64_mask(next_y, one);
    const auto even_axis = static_cast<__mmask8>((cross_x & even_x) | (cross_y & even_y));
    __mmask8 up = 0;
    switch (walk_.schedule.up) {
      case UpRule::kNever:
        break;
      case UpRule::kAlways:
        up = 0xFF;
        break;
      case UpRule::kInterval:
        up = _mm512_testn_epi64_mask(level, one);
        break;
      case UpRule::kEvenAxis:
        up = even_axis;
        break;
      case UpRule::kBothEven:
        up = static_cast<__mmask8>(even_x & even_y);
        break;
      case UpRule::kSelective:
        up = 0xFF;
        [[fallthrough]];
      case UpRule::kSelectiveEven: {
        if (walk_.schedule.up == UpRule::kSelectiveEven) up = even_axis;
        const __m512i next_out =
            _mm512_min_epi64(at(g.x, exit_plane(next_x, level)), at(g.y, exit_plane(next_y, level)));
        up = static_cast<__mmask8>(
            up & (rising | _mm512_cmpge_epi64_mask(_mm512_max_epi64(t_out, t_z), next_out)));
        break;
      }
      case UpRule::kCoherent:
        up = _mm512_cmpeq_epi64_mask(load(g.last_crossed), level);
        break;
    }
    up = static_cast<__mmask8>(up & skip & _mm512_cmplt_epi64_mask(level, _mm512_set1_epi64(root_level)));
    next_x = _mm512_mask_srai_epi64(next_x, up, next_x, 1);
    next_y = _mm512_mask_srai_epi64(next_y, up, next_y, 1);
    __m512i next_level = _mm512_mask_add_epi64(level, up, level, one);
    next_level = _mm512_mask_sub_epi64(next_level, down, next_level, one);
    store(g.last_crossed, _mm512_mask_mov_epi64(_mm512_set1_epi64(-1), skip, level));
    store(g.t_cur, t_next);

    // Before the next visit.
    auto gone = static_cast<__mmask8>(_mm512_cmpge_epi64_mask(t_next, t_max) |
                                      (rising & _mm512_cmple_epi64_mask(load(g.t_root), t_next)));
    if (walk_.map.address_mode == AddressMode::kBorder) {
      const __m512i size = _mm512_set1_epi64(walk_.x.size);
      gone =
          static_cast<__mmask8>(gone | _mm512_cmpge_epi64_mask(_mm512_sllv_epi64(next_x, next_level), size) |
                                _mm512_cmpge_epi64_mask(_mm512_sllv_epi64(next_y, next_level), size));
    }

    // More levels at once, before the first crossing.
    if (walk_.schedule.down > 1) {
      const __m512i levels_down = load(g.down);
      for (int d = 2; d <= walk_.schedule.down; ++d) {
        const __m512i least = _mm512_set1_epi64(d);
        const auto further =
            static_cast<__mmask8>(down & _mm512_cmpge_epi64_mask(levels_down, least) &
                                  _mm512_cmpge_epi64_mask(_mm512_sub_epi64(level, stop), least));
        if (further == 0) break;
        const __mmask8 right = _mm512_cmple_epi64_mask(at(g.x, middle_plane(next_x, next_level)), reached);
        const __mmask8 above = _mm512_cmple_epi64_mask(at(g.y, middle_plane(next_y, next_level)), reached);
        next_x = _mm512_mask_add_epi64(next_x, further, next_x, next_x);
        next_y = _mm512_mask_add_epi64(next_y, further, next_y, next_y);
        next_x = _mm512_mask_add_epi64(next_x, static_cast<__mmask8>(further & right), next_x, one);
        next_y = _mm512_mask_add_epi64(next_y, static_cast<__mmask8>(further & above), next_y, one);
        next_level = _mm512_mask_sub_epi64(next_level, further, next_level, one);
      }
      store(g.down, _mm512_mask_mov_epi64(levels_down, skip, one));
    }
    store(g.node_x, next_x);
    store(g.node_y, next_y);
    store(g.level, next_level);

    // Rays that have ended.
    unsigned ended = g.active & (hit | gone);
    if (ended == 0) return;
    Lane64 old_x, old_y;
    store(old_x, node_x);
    store(old_y, node_y);
    for (; ended != 0; ended &= ended - 1) {
      const int lane = std::countr_zero(ended);
      HitRecord record;
      const uint32_t ray = g.ray[lane];
      record.ray_id = rays_[order_.empty() ? ray : order_[ray]].id;
      record.steps = static_cast<uint32_t>(g.steps.at[lane]);
      if ((hit >> lane & 1) != 0) {
        const int64_t x = in_x.at[lane], y = in_y.at[lane];
        record.status = HitStatus::kHit;
        record.face = top.at[lane] != 0                      ? HitFace::kTop
                      : std::max(x, y) >= g.t_start.at[lane] ? (x >= y ? HitFace::kWallX : HitFace::kWallY)
                                                             : HitFace::kInside;
        record.stop_level = static_cast<uint8_t>(walk_.schedule.stop_level);
        const PlainAxis axis_x{old_x.at[lane], g.flip_x.at[lane]}, axis_y{old_y.at[lane], g.flip_y.at[lane]};
        record.i = static_cast<int32_t>(axis_x.real_index(walk_.x, walk_.schedule.stop_level));
        record.j = static_cast<int32_t>(axis_y.real_index(walk_.y, walk_.schedule.stop_level));
        record.t = t_hit.at[lane];
      }
      finish(g, first_lane, lane, record);
    }
  }

  const PlainWalk& walk_;
  std::span<const MachineRay> rays_;
  std::span<const uint32_t> order_;
  std::span<HitRecord> hits_;
  const LineRecorder* recorder_;
  const uint16_t* texels_;
  std::array<int64_t, 32> first_{};       ///< texels before each level
  std::array<int64_t, 32> line_base_{};   ///< bytes
  std::array<int64_t, 32> line_pitch_{};  ///< bytes from row to row, or from row of blocks to row of blocks
  bool blocks_ = false;                   ///< the layout is blocks_4x4
  int texel_shift_ = 0;
  size_t capacity_ = 256;          ///< steps of a lane in scratch_
  std::vector<uint32_t> scratch_;  ///< lines of the rays under way
  size_t next_ = 0;
};

}  // namespace

bool lanes_can(const Walk<FixedArithmetic, PlainAxis>& walk) {
  const NumberFormat& number = walk.format.number;
  const bool tiled =
      walk.map.address_mode == AddressMode::kBorder || walk.map.address_mode == AddressMode::kWrap;
  return tiled && walk.schedule.down != kDownCommon && walk.schedule.fetch == FetchRule::kTexel &&
         __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
         number.mantissa_bits + number.fraction_bits <= 30 && walk.map.root_level + number.tile_bits <= 28;
}

void traverse_lanes(const Walk<FixedArithmetic, PlainAxis>& walk, const Pyramid& pyramid,
                    std::span<const MachineRay> rays, std::span<const uint32_t> order,
                    std::span<HitRecord> hits, const LineRecorder* recorder) {
  LaneTraversal(walk, pyramid, rays, order, hits, recorder).run();
}

}  // namespace cuesta

#else

namespace cuesta {

bool lanes_can(const Walk<FixedArithmetic, PlainAxis>&) { return false; }
void traverse_lanes(const Walk<FixedArithmetic, PlainAxis>&, const Pyramid&, std::span<const MachineRay>,
                    std::span<const uint32_t>, std::span<HitRecord>, const LineRecorder*) {}

}  // namespace cuesta

#endif
