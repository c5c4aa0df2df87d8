#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include <optional>

#include "models/oracle/exact_ray.h"

namespace cuesta {

/// Wide enough for the products that comparing times of a traced ray takes; unused limbs cost nothing.
using BigInt = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    2048, 2048, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked, void>>;

/// The ray as traced, before anything is rounded: in texels and height LSBs as fractions of whole numbers; times are
/// the traced ray's t. What the reference makes exact is exact: a secondary ray's fixed coordinate; t ends at t_max or
/// when an axis has crossed 2^w2 tiles. For rays with t_min = 0; nothing for a ray whose components differ by more
/// than 2^300 in size. `dead` as `quantise` says.
std::optional<ExactRay<BigInt>> exact_traced_ray(const TracedRay& traced, const MapShape& map,
                                                 const NumberFormat& format, bool dead);

/// Time units of a machine ray of this format and exponent in one unit of a traced ray's t.
BigInt machine_units_of(const NumberFormat& format, int exponent);

}  // namespace cuesta
