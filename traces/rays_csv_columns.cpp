#include "traces/rays_csv_columns.h"

#include <charconv>
#include <limits>
#include <type_traits>

#include "traces/ray_trace.h"

namespace cuesta {
namespace {

constexpr uint64_t kNoParent = std::numeric_limits<uint64_t>::max();

template <typename T>
void append_number(T value, std::string& text) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  text.append(buffer, end);
}

/// The whole text must be the number.
template <typename T>
bool parse_number(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// Get is a captureless lambda from a ray to a reference to one of its fields.
template <auto Get>
constexpr RayColumn number_column(std::string_view name, std::string_view accepted, bool required = false) {
  return {
      name, required, accepted,
      [](const TracedRay& ray, std::string& text) { append_number(Get(const_cast<TracedRay&>(ray)), text); },
      [](std::string_view text, TracedRay& ray) { return parse_number(text, Get(ray)); }};
}

template <auto Get, int Count>
constexpr RayColumn name_column(std::string_view name, std::string_view accepted) {
  return {name, false, accepted,
          [](const TracedRay& ray, std::string& text) { text += name_of(Get(const_cast<TracedRay&>(ray))); },
          [](std::string_view text, TracedRay& ray) {
            using E = std::remove_reference_t<decltype(Get(ray))>;
            for (int k = 0; k < Count; ++k) {
              if (text != name_of(static_cast<E>(k))) continue;
              Get(ray) = static_cast<E>(k);
              return true;
            }
            return false;
          }};
}

constexpr std::string_view kFinite = "a finite number";
constexpr std::string_view kTime = "a number >= 0, such as 0.5";
constexpr std::string_view kCount = "an integer from 0 to 4294967295";

constexpr RayColumn kColumns[] = {number_column < [](TracedRay & r) -> auto& {return r.id;
}  // namespace
> ("id", "an integer from 0 to 2^64 - 1", true), number_column < [](TracedRay& r) -> auto& {
  return r.origin[0];
}
> ("origin_u", kFinite, true), number_column < [](TracedRay& r) -> auto& { return r.origin[1]; }
> ("origin_v", kFinite, true), number_column < [](TracedRay& r) -> auto& { return r.origin[2]; }
> ("origin_z", kFinite, true), number_column < [](TracedRay& r) -> auto& { return r.direction[0]; }
> ("direction_u", kFinite, true), number_column < [](TracedRay& r) -> auto& { return r.direction[1]; }
> ("direction_v", kFinite, true), number_column < [](TracedRay& r) -> auto& { return r.direction[2]; }
> ("direction_z", kFinite, true), number_column < [](TracedRay& r) -> auto& { return r.t_min; }
> ("t_min", kTime), number_column < [](TracedRay& r) -> auto& { return r.t_max; }
> ("t_max", "a number >= 0, or inf"), number_column < [](TracedRay& r) -> auto& { return r.pixel_x; }
> ("pixel_x", kCount), number_column < [](TracedRay& r) -> auto& { return r.pixel_y; }
> ("pixel_y", kCount), name_column < [](TracedRay& r) -> auto& { return r.kind; }
, 4 > ("kind", "primary, shadow, reflection or refraction"), name_column < [](TracedRay& r) -> auto& {
  return r.fixed_axis;
}
, 4 > ("fixed_axis", "none, x, y or z"), number_column < [](TracedRay& r) -> auto& {
  return r.fixed_coordinate;
}
> ("fixed_coordinate", "an integer of 32 bits and a sign"), number_column < [](TracedRay& r) -> auto& {
  return r.light;
}
> ("light", "an integer from 0 to 65535"),
    {"parent", false, "the id of a ray, or none",
     [](const TracedRay& ray, std::string& text) {
       if (ray.parent == kNoParent) {
         text += "none";
       } else {
         append_number(ray.parent, text);
       }
     },
     [](std::string_view text, TracedRay& ray) {
       ray.parent = kNoParent;
       return text == "none" || parse_number(text, ray.parent);
     }},
    number_column < [](TracedRay& r) -> auto& {
  return r.gradient[0];
}
> ("du_dpx", kFinite), number_column < [](TracedRay& r) -> auto& { return r.gradient[1]; }
> ("dv_dpx", kFinite), number_column < [](TracedRay& r) -> auto& { return r.gradient[2]; }
> ("du_dpy", kFinite), number_column < [](TracedRay& r) -> auto& { return r.gradient[3]; }
> ("dv_dpy", kFinite),
};  // namespace cuesta

}  // namespace

std::span<const RayColumn> ray_columns() { return kColumns; }

}  // namespace cuesta
