#include "traces/rays_reader.h"

#include <zstd.h>

#include <filesystem>
#include <new>

#include "models/common/error.h"
#include "traces/rays_format.h"

namespace cuesta {

using namespace rays_format;

void RayReader::fail(const std::string& what) const {
  throw input_error("Cannot read the ray trace " + path_ + ": " + what + ".");
}

void RayReader::fail_in_chunk(const std::string& what) const {
  fail("chunk " + std::to_string(chunk_) + " of " + std::to_string(chunk_count_) + " " + what);
}

void RayReader::read(void* bytes, size_t size) {
  if (!file_.read(static_cast<char*>(bytes), static_cast<std::streamsize>(size))) {
    fail("reading failed at byte " + std::to_string(position_));
  }
  position_ += size;
}

RayReader::RayReader(const std::string& path) : path_(path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail("there is no such file");
  if (!std::filesystem::is_regular_file(status)) fail("it is not a regular file");
  file_bytes_ = std::filesystem::file_size(path, error);
  file_.open(path, std::ios::binary);
  if (error || !file_) fail("the file cannot be opened");
  if (file_bytes_ < kHeaderBytes) {
    fail(file_bytes_ == 0 ? "the file is empty"
                          : "it has " + std::to_string(file_bytes_) + " bytes, and the header alone takes " +
                                std::to_string(kHeaderBytes));
  }
  HeaderBytes bytes;
  read(bytes.data(), bytes.size());
  if (!has_magic(bytes)) fail("it is not a .rays file: it does not begin with the format's eight bytes");
  const FileHeader header = decode(bytes);
  if (!checksum_holds(bytes)) fail("its header is damaged: the checksum does not match");
  if (header.version != kVersion) {
    fail("it has version " + std::to_string(header.version) + " of the format; this program reads version " +
         std::to_string(kVersion));
  }
  if (header.header_bytes != kHeaderBytes || header.record_bytes != kRecordBytes) {
    fail("its header states " + std::to_string(header.header_bytes) + " bytes of header and " +
         std::to_string(header.record_bytes) + " per ray; version 1 has 64 and 112");
  }
  if (header.chunk_rays < 1 || header.chunk_rays > kMostChunkRays) {
    fail("its header states " + std::to_string(header.chunk_rays) +
         " rays per chunk; 1 to 65536 are accepted");
  }
  const std::string fault = fault_of_grid(header.width, header.height);
  if (!fault.empty()) fail("its header states " + fault);
  const uint64_t whole = header.ray_count / header.chunk_rays;
  if (header.chunk_count != whole + (header.ray_count % header.chunk_rays != 0)) {
    fail("its header states " + std::to_string(header.ray_count) + " rays in " +
         std::to_string(header.chunk_count) + " chunks of " + std::to_string(header.chunk_rays) +
         ", which contradict each other");
  }
  if (header.chunk_count > (file_bytes_ - kHeaderBytes) / kChunkHeaderBytes) {
    fail("it is truncated: its header states " + std::to_string(header.chunk_count) + " chunks, and only " +
         std::to_string(file_bytes_ - kHeaderBytes) + " bytes follow");
  }
  width_ = static_cast<int>(header.width);
  height_ = static_cast<int>(header.height);
  chunk_rays_ = header.chunk_rays;
  ray_count_ = header.ray_count;
  chunk_count_ = header.chunk_count;
}

bool RayReader::next_chunk(std::vector<TracedRay>& rays) {
  const uint64_t left = file_bytes_ - position_;
  if (chunk_ == chunk_count_) {
    if (left != 0) fail(std::to_string(left) + " bytes follow its last chunk, where the file must end");
    return false;
  }
  if (left < kChunkHeaderBytes) fail_in_chunk("is truncated: the file ends inside its header");
  ChunkHeaderBytes bytes;
  read(bytes.data(), bytes.size());
  const ChunkHeader header = decode(bytes);
  if (!has_magic(bytes) || !checksum_holds(bytes)) fail_in_chunk("has a damaged header");
  if (header.index != chunk_) {
    fail_in_chunk("is out of place: its header says that it is chunk " + std::to_string(header.index));
  }
  const uint64_t expected = std::min<uint64_t>(chunk_rays_, ray_count_ - rays_read_);
  if (header.rays != expected) {
    fail_in_chunk("states " + std::to_string(header.rays) + " rays where the file's header gives it " +
                  std::to_string(expected));
  }
  const size_t record_bytes = static_cast<size_t>(expected) * kRecordBytes;
  if (header.stored_bytes > file_bytes_ - position_) {
    fail_in_chunk("is truncated: it states " + std::to_string(header.stored_bytes) + " bytes, and " +
                  std::to_string(file_bytes_ - position_) + " are left");
  }
  if (header.stored_bytes > 2 * ZSTD_compressBound(record_bytes)) {
    fail_in_chunk("states " + std::to_string(header.stored_bytes) +
                  " bytes, far more than its rays can take");
  }
  stored_.resize(header.stored_bytes);
  read(stored_.data(), stored_.size());
  if (checksum(stored_) != header.stored_checksum) fail_in_chunk("is damaged: the checksum does not match");
  records_.resize(record_bytes);
  const size_t size = ZSTD_decompress(records_.data(), records_.size(), stored_.data(), stored_.size());
  if (ZSTD_isError(size)) fail_in_chunk(std::string("cannot be decompressed: ") + ZSTD_getErrorName(size));
  if (size != record_bytes) {
    fail_in_chunk("decompresses to " + std::to_string(size) + " bytes; its rays take " +
                  std::to_string(record_bytes));
  }
  for (uint64_t k = 0; k < expected; ++k, ++rays_read_) {
    rays.push_back(decode_record(records_.data() + k * kRecordBytes));
    const std::string fault = fault_of(rays.back(), width_, height_);
    if (!fault.empty()) {
      fail_in_chunk("holds a damaged ray, ray " + std::to_string(rays_read_) + " (id " +
                    std::to_string(rays.back().id) + "): " + fault);
    }
  }
  ++chunk_;
  return true;
}

RayTrace read_rays(const std::string& path, const RayWatch& watch) {
  try {
    RayReader reader(path);
    RayTrace trace{reader.width(), reader.height(), {}};
    std::vector<uint64_t> ids;
    while (reader.next_chunk(trace.rays)) keep_watch(watch, trace.rays.size());
    ids.reserve(trace.rays.size());
    for (const TracedRay& ray : trace.rays) ids.push_back(ray.id);
    require_distinct_ids(std::move(ids), "Cannot read the ray trace " + path);
    return trace;
  } catch (const std::bad_alloc&) {
    throw Error(ExitCode::kResource, "Cannot read the ray trace " + path + ": memory does not suffice.");
  }
}

}  // namespace cuesta
