#include "sim/verify/lockstep/comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "models/oracle/random_cases.h"

namespace cuesta {
namespace {

constexpr std::string_view kNone = "none";
constexpr size_t kMostKept = 1 << 14;  ///< compared entries of a log

constexpr std::array<std::string_view, 3> kStatusNames = {"miss", "hit", "did not finish"};
constexpr std::array<std::string_view, 5> kFaceNames = {"none", "top", "wall_x", "wall_y", "inside"};

template <size_t N>
std::string named(const std::array<std::string_view, N>& names, uint8_t value) {
  return fmt::format("{} ({:#x})", value < N ? names[value] : "unknown", value);
}

/// Counted ahead of time, or by hardware when the request leaves in the place of its allocation: compared at the end.
bool known_at_the_end_only(const std::string& path) {
  return path == "ray_dispatch.rays" || path.starts_with("ray_setup[") || path.ends_with("].unique_lines");
}

/// Goes on while both logs have the same entry of a cycle below `end`; true where one then has another one.
template <class Entry>
bool differ(const std::vector<Entry>& left, const std::vector<Entry>& right, size_t& place, Cycle end) {
  for (;; ++place) {
    const bool in_left = place < left.size() && left[place].cycle < end;
    const bool in_right = place < right.size() && right[place].cycle < end;
    if (!in_left && !in_right) return false;
    if (in_left != in_right || !(left[place] == right[place])) return true;
  }
}

template <class Entry>
const Entry* entry(const std::vector<Entry>& log, size_t place, Cycle cycle) {
  return place < log.size() && log[place].cycle == cycle ? &log[place] : nullptr;
}

/// Of the two at `place`, the cycle of the one that comes first.
template <class Entry>
Cycle first_cycle(const std::vector<Entry>& left, const std::vector<Entry>& right, size_t place) {
  return std::min(place < left.size() ? left[place].cycle : kNever,
                  place < right.size() ? right[place].cycle : kNever);
}

template <class Entry>
void forget(std::vector<Entry>& left, std::vector<Entry>& right, size_t& place) {
  if (place < kMostKept) return;
  left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(place));
  right.erase(right.begin(), right.begin() + static_cast<std::ptrdiff_t>(place));
  place = 0;
}

std::string unit(std::string_view name, size_t pipeline) { return fmt::format("{}[{}].", name, pipeline); }

}  // namespace

Comparison::Comparison(LockstepRig& left, LockstepRig& right)
    : left_(left), right_(right), places_(left.logs().size()) {}

std::vector<Difference> Comparison::until(Cycle end) {
  for (size_t p = 0; p < places_.size(); ++p) {
    compare_entries(p, end);
    compare_requests(p, end);
    compare_hits(p, end);
    compare_fills(static_cast<int>(p), end);
  }
  compare_counters(false, end);
  compare("machine.done", end - 1, left_.done(), right_.done());
  // Model and hardware say it in their own words.
  const auto code = [](const LockstepRig& rig) { return rig.stuck() ? rig.stuck()->code() : ExitCode::kOk; };
  if (code(left_) != code(right_)) {
    auto text = [](const LockstepRig& rig) { return rig.stuck() ? rig.stuck()->what() : "goes on"; };
    add("machine.progress", end - 1, text(left_), text(right_));
  }
  return found();
}

std::vector<Difference> Comparison::at_the_end(Cycle end) {
  compare_counters(true, end);
  compare("machine.cycles", end - 1, left_.machine().cycles(), right_.machine().cycles());
  compare_timing(end);
  return found();
}

std::vector<Difference> Comparison::found() {
  sort_by_cause(differences_);
  return differences_;
}

void Comparison::add(const std::string& path, Cycle cycle, const std::string& left, const std::string& right,
                     uint32_t ray) {
  Difference difference = difference_of(path, cycle);
  difference.values[0] = left;
  difference.values[1] = right;
  if (ray != kNoRay) difference.ray = ray_text(ray);
  differences_.push_back(std::move(difference));
}

void Comparison::compare(const std::string& path, Cycle cycle, int64_t left, int64_t right) {
  if (left != right) add(path, cycle, decoded(left), decoded(right));
}

void Comparison::compare_entries(size_t p, Cycle end) {
  auto &left = left_.logs()[p].entries, &right = right_.logs()[p].entries;
  size_t& place = places_[p].entries;
  if (differ(left, right, place, end)) {
    const Cycle cycle = first_cycle(left, right, place);
    const PortLog::Entry *a = entry(left, place, cycle), *b = entry(right, place, cycle);
    auto text = [](const PortLog::Entry* e) {
      return e == nullptr ? std::string(kNone) : fmt::format("ray {} ({:#x}) enters", e->ray, e->ray);
    };
    add(unit("ray_setup", p) + "entry", cycle, text(a), text(b), a != nullptr ? a->ray : b->ray);
  }
  forget(left, right, place);
}

void Comparison::compare_requests(size_t p, Cycle end) {
  auto &left = left_.logs()[p].requests, &right = right_.logs()[p].requests;
  size_t& place = places_[p].requests;
  const size_t before = place;
  const bool different = differ(left, right, place, end);
  requests_ += place - before;
  if (different) {
    const Cycle cycle = first_cycle(left, right, place);
    const PortLog::Request *a = entry(left, place, cycle), *b = entry(right, place, cycle);
    const std::string path = unit("height_l1", p) + "request";
    const uint32_t owner = a != nullptr ? a->owner : b->owner;
    if (a == nullptr || b == nullptr) {
      add(path, cycle, a == nullptr ? std::string(kNone) : request_text(*a),
          b == nullptr ? std::string(kNone) : request_text(*b), owner);
    } else {
      if (a->mshr != b->mshr) add(path + ".mshr", cycle, decoded(a->mshr), decoded(b->mshr), owner);
      if (a->address != b->address)
        add(path + ".address", cycle, address_text(a->address), address_text(b->address), owner);
      if (a->owner != b->owner) add(path + ".owner", cycle, decoded(a->owner), decoded(b->owner), owner);
    }
  }
  forget(left, right, place);
}

void Comparison::compare_hits(size_t p, Cycle end) {
  auto &left = left_.logs()[p].hits, &right = right_.logs()[p].hits;
  size_t& place = places_[p].hits;
  if (differ(left, right, place, end)) {
    const Cycle cycle = first_cycle(left, right, place);
    const PortLog::Hit *a = entry(left, place, cycle), *b = entry(right, place, cycle);
    const std::string path = unit("traverse", p) + "hit";
    const uint32_t ray = a != nullptr ? a->ray : b->ray;
    auto text = [](const PortLog::Hit* hit) { return hit == nullptr ? std::string(kNone) : hit_text(*hit); };
    if (a == nullptr || b == nullptr || a->ray != b->ray) {
      add(path, cycle, text(a), text(b), ray);
    } else {
      const HitRecord &x = a->record, &y = b->record;
      auto field = [&](const char* name, bool same, const std::string& l, const std::string& r) {
        if (!same) add(path + "." + name, cycle, l, r, ray);
      };
      auto number = [&](const char* name, int64_t l, int64_t r) {
        field(name, l == r, decoded(l), decoded(r));
      };
      field("status", x.status == y.status, named(kStatusNames, static_cast<uint8_t>(x.status)),
            named(kStatusNames, static_cast<uint8_t>(y.status)));
      field("face", x.face == y.face, named(kFaceNames, static_cast<uint8_t>(x.face)),
            named(kFaceNames, static_cast<uint8_t>(y.face)));
      number("stop_level", x.stop_level, y.stop_level);
      number("i", x.i, y.i);
      number("j", x.j, y.j);
      number("t", x.t, y.t);
      number("steps", x.steps, y.steps);
      number("ray_id", static_cast<int64_t>(x.ray_id), static_cast<int64_t>(y.ray_id));
    }
  }
  forget(left, right, place);
}

void Comparison::compare_fills(int pipeline, Cycle end) {
  const PipelineFill a = left_.machine().fill(pipeline), b = right_.machine().fill(pipeline);
  auto fill = [&](const char* name, const char* field, int left, int right) {
    if (left != right) compare(unit(name, static_cast<size_t>(pipeline)) + field, end - 1, left, right);
  };
  if (by_cycle_) fill("ray_setup", "rays_before_traverse", a.rays_before_traverse, b.rays_before_traverse);
  fill("traverse", "contexts", a.contexts, b.contexts);
  if (!left_.hides_mshrs() && !right_.hides_mshrs()) {
    fill("height_l1", "mshrs", a.mshrs, b.mshrs);
    fill("height_l1", "retries", a.retries, b.retries);
  }
  fill("hit_queue", "fill", a.hit_queue, b.hit_queue);
  fill("result_writer", "burst_records", a.burst_records, b.burst_records);
  fill("result_writer", "bursts_unacknowledged", a.bursts, b.bursts);
}

void Comparison::compare_counters(bool whole, Cycle end) {
  const Counters a = left_.machine().counters(), b = right_.machine().counters();
  if (a.all() == b.all()) return;
  for (const auto& [path, value] : a.all()) {
    if (whole || !known_at_the_end_only(path)) compare(path, end - 1, value, b.get(path));
  }
  for (const auto& [path, value] : b.all()) {
    if (!a.all().contains(path) && (whole || !known_at_the_end_only(path))) compare(path, end - 1, 0, value);
  }
}

/// What each ray took, beyond its completion.
void Comparison::compare_timing(Cycle end) {
  const auto rays = static_cast<uint32_t>(left_.work().rays.size());
  for (uint32_t ray = 0; ray < rays && differences_.size() < 100; ++ray) {
    const uint32_t position = left_.position(ray);
    const RayTiming &a = left_.machine().timing(position), &b = right_.machine().timing(position);
    auto field = [&](const char* name, int64_t left, int64_t right) {
      if (left != right)
        add(std::string("ray.") + name, std::min(a.completed, end - 1), decoded(left), decoded(right), ray);
    };
    field("completed", a.completed, b.completed);
    field("latency", a.latency, b.latency);
    field("issue_slots", a.issue_slots, b.issue_slots);
    field("misses", a.misses, b.misses);
  }
}

std::string Comparison::ray_text(uint32_t ray) const {
  const uint32_t position = left_.position(ray);
  const MachineRay& value = left_.work().rays[position];
  return fmt::format("{} in the machine's order, {} of the trace, pixel number {}: {}", ray, position,
                     left_.work().pixels[position], describe(value));
}

std::string Comparison::address_text(uint64_t address) const {
  const TexelLayout& layout = left_.layout();
  const Pyramid& pyramid = *left_.work().pyramid;
  // Whatever the layout is: the first texel at or behind the address.
  uint64_t best = ~uint64_t{0};
  std::string texel = "no texel";
  for (int level = 0; level <= pyramid.root_level(); ++level) {
    for (int j = 0; j < pyramid.height(level); ++j) {
      for (int i = 0; i < pyramid.width(level); ++i) {
        const uint64_t offset = layout.offset(level, i, j);
        if (offset < address || offset >= best) continue;
        best = offset;
        texel = fmt::format("level {}, i {}, j {}", level, i, j);
      }
    }
  }
  return fmt::format("address {} ({:#x}), from {} on", address, address, texel);
}

std::string Comparison::request_text(const PortLog::Request& request) const {
  return fmt::format("MSHR {}, {}", request.mshr, address_text(request.address));
}

std::string Comparison::hit_text(const PortLog::Hit& hit) {
  const HitRecord& r = hit.record;
  return fmt::format("ray {}: {}, face {}, stop level {}, i {}, j {}, t {}, steps {}", hit.ray,
                     named(kStatusNames, static_cast<uint8_t>(r.status)),
                     named(kFaceNames, static_cast<uint8_t>(r.face)), r.stop_level, decoded(r.i),
                     decoded(r.j), decoded(r.t), decoded(r.steps));
}

}  // namespace cuesta
