#pragma once

#include <span>
#include <string>
#include <string_view>

#include "models/rays/traced_ray.h"

namespace cuesta {

/// A column of the text form of a trace.
struct RayColumn {
  std::string_view name;
  bool required;
  std::string_view accepted;  ///< "a finite number", for messages
  void (*append)(const TracedRay& ray, std::string& text);
  /// False when the text is not of this column's kind; the ray is then unspecified.
  bool (*parse)(std::string_view text, TracedRay& ray);
};

/// In the order in which they are written.
std::span<const RayColumn> ray_columns();

}  // namespace cuesta
