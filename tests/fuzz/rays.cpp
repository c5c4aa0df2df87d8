#include <algorithm>
#include <vector>

#include "models/common/error.h"
#include "tests/fuzz/scratch_file.h"
#include "traces/rays_format.h"
#include "traces/rays_reader.h"
#include "traces/rays_writer.h"

namespace cuesta::fuzz {
namespace {

using namespace rays_format;

/// Puts the checksum of `bytes` without their last eight into these.
void sign(std::span<uint8_t> bytes) {
  const uint64_t sum = checksum(bytes.first(bytes.size() - 8));
  for (size_t k = 0; k < 8; ++k) bytes[bytes.size() - 8 + k] = static_cast<uint8_t>(sum >> (8 * k));
}

/// With checksums that hold, so that the fuzzer's changes reach what lies behind them.
std::vector<uint8_t> signed_copy(Bytes bytes) {
  std::vector<uint8_t> copy(bytes.begin(), bytes.end());
  const std::span<uint8_t> all(copy);
  if (all.size() < kHeaderBytes) return copy;
  sign(all.first(kHeaderBytes));
  for (size_t at = kHeaderBytes; at + kChunkHeaderBytes <= all.size();) {
    ChunkHeader header =
        decode(std::span<const uint8_t, kChunkHeaderBytes>(all.subspan(at, kChunkHeaderBytes)));
    const size_t left = all.size() - at - kChunkHeaderBytes;
    const size_t stored = std::min<size_t>(header.stored_bytes, left);
    header.stored_checksum = checksum(all.subspan(at + kChunkHeaderBytes, stored));
    const ChunkHeaderBytes right = encode(header);
    std::copy(right.begin(), right.end(), all.begin() + static_cast<std::ptrdiff_t>(at));
    at += kChunkHeaderBytes + stored;
  }
  return copy;
}

void read(Bytes bytes) {
  try {
    const std::string path = scratch_file("in.rays", bytes);
    const RayTrace trace = read_rays(path);
    require(check_rays(path).rays == trace.rays.size(), "a file that is read can be checked");
    const std::string again = scratch_file("again.rays", {});
    write_rays(again, trace);
    require(identical(trace, read_rays(again)), "what was read comes back the same from a file");
  } catch (const Error&) {
  }
}

}  // namespace
}  // namespace cuesta::fuzz

void cuesta::fuzz::rays(Bytes bytes) {
  read(bytes);
  read(signed_copy(bytes));
}
