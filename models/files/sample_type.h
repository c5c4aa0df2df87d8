#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace cuesta {

/// The number types of files. `half` is handed over as float, exactly.
enum class SampleKind : uint8_t { kUint8, kUint16, kUint32, kInt8, kInt16, kInt32, kHalf, kFloat, kDouble };

/// What the reader needs to know of a number type.
struct SampleType {
  SampleKind kind;
  std::string_view name;
  bool integer;
  bool is_signed;
  double largest;  ///< of an integer type
  int bits;        ///< of a height, unless the user asks for others
  int bytes;       ///< of a number as `read_rows` hands it over
};

/// All number types, in the order of SampleKind.
std::span<const SampleType> sample_types();
inline const SampleType& sample_type(SampleKind kind) { return sample_types()[static_cast<size_t>(kind)]; }

}  // namespace cuesta
