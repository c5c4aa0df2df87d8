#include "models/files/sample_type.h"

#include <array>

namespace cuesta {
namespace {

constexpr std::array<SampleType, 9> kSampleTypes = {{
    {SampleKind::kUint8, "uint8", true, false, 255.0, 8, 1},
    {SampleKind::kUint16, "uint16", true, false, 65535.0, 16, 2},
    {SampleKind::kUint32, "uint32", true, false, 4294967295.0, 16, 4},
    {SampleKind::kInt8, "int8", true, true, 127.0, 8, 1},
    {SampleKind::kInt16, "int16", true, true, 32767.0, 16, 2},
    {SampleKind::kInt32, "int32", true, true, 2147483647.0, 16, 4},
    {SampleKind::kHalf, "half", false, true, 1.0, 16, 4},
    {SampleKind::kFloat, "float", false, true, 1.0, 16, 4},
    {SampleKind::kDouble, "double", false, true, 1.0, 16, 8},
}};

}  // namespace

std::span<const SampleType> sample_types() { return kSampleTypes; }

}  // namespace cuesta
