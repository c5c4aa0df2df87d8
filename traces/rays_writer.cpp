#include "traces/rays_writer.h"

#include <unistd.h>
#include <zstd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "models/common/error.h"
#include "traces/rays_format.h"

namespace cuesta {

using namespace rays_format;

namespace {
constexpr int kCompressionLevel = 3;  // zstd's own default
}

RayWriter::RayWriter(const std::string& path, int width, int height)
    : path_(path), temporary_(path + ".partial-" + std::to_string(getpid())), width_(width), height_(height) {
  const std::string fault = fault_of_grid(static_cast<uint64_t>(width), static_cast<uint64_t>(height));
  if (width < 1 || height < 1 || !fault.empty()) {
    throw input_error("Cannot write " + path + ": " + fault + ".");
  }
  file_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!file_) {
    throw Error(ExitCode::kResource, "Cannot write " + path + ": the file " + temporary_ +
                                         " cannot be created: " + std::strerror(errno) + ".");
  }
  records_.reserve(kChunkRays * kRecordBytes);
  const HeaderBytes place{};
  write(place.data(), place.size());
}

RayWriter::~RayWriter() {
  if (finished_) return;
  file_.close();
  std::remove(temporary_.c_str());
}

void RayWriter::write(const void* bytes, size_t size) {
  if (!file_.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size))) {
    throw Error(ExitCode::kResource, "Cannot write " + path_ + ": writing failed; is the disk full?");
  }
}

void RayWriter::add(const TracedRay& ray) {
  const std::string fault = fault_of(ray, width_, height_);
  if (!fault.empty()) {
    throw input_error("Cannot write " + path_ + ": ray " + std::to_string(ray_count_) + " (id " +
                      std::to_string(ray.id) + ") is damaged: " + fault + ".");
  }
  records_.resize(records_.size() + kRecordBytes);
  encode_record(ray, records_.data() + records_.size() - kRecordBytes);
  ++ray_count_;
  if (records_.size() == kChunkRays * kRecordBytes) write_chunk();
}

void RayWriter::write_chunk() {
  stored_.resize(ZSTD_compressBound(records_.size()));
  const size_t size =
      ZSTD_compress(stored_.data(), stored_.size(), records_.data(), records_.size(), kCompressionLevel);
  if (ZSTD_isError(size)) {
    throw Error(ExitCode::kResource, "Cannot write " + path_ + ": zstd could not compress a chunk: " +
                                         ZSTD_getErrorName(size) + ".");
  }
  ChunkHeader header;
  header.rays = static_cast<uint32_t>(records_.size() / kRecordBytes);
  header.index = chunk_count_++;
  header.stored_bytes = static_cast<uint32_t>(size);
  header.stored_checksum = checksum({stored_.data(), size});
  const ChunkHeaderBytes bytes = encode(header);
  write(bytes.data(), bytes.size());
  write(stored_.data(), size);
  records_.clear();
}

void RayWriter::finish() {
  if (!records_.empty()) write_chunk();
  FileHeader header;
  header.ray_count = ray_count_;
  header.chunk_count = chunk_count_;
  header.width = static_cast<uint32_t>(width_);
  header.height = static_cast<uint32_t>(height_);
  const HeaderBytes bytes = encode(header);
  file_.seekp(0);
  write(bytes.data(), bytes.size());
  file_.close();
  if (!file_ || std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    throw Error(ExitCode::kResource, "Cannot write " + path_ + ": " + temporary_ +
                                         " could not be completed and renamed; is the disk full, or the name "
                                         "that of a folder?");
  }
  finished_ = true;
}

void write_rays(const std::string& path, const RayTrace& trace, const RayWatch& watch) {
  std::vector<uint64_t> ids;
  ids.reserve(trace.rays.size());
  for (const TracedRay& ray : trace.rays) ids.push_back(ray.id);
  require_distinct_ids(std::move(ids), "Cannot write " + path);
  RayWriter writer(path, trace.width, trace.height);
  for (size_t k = 0; k < trace.rays.size(); ++k) {
    if (k % kChunkRays == 0) keep_watch(watch, k);
    writer.add(trace.rays[k]);
  }
  writer.finish();
}

}  // namespace cuesta
