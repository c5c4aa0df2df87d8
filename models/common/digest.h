#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace cuesta {

/// SHA-256 over little-endian values, whatever the host.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;

  void bytes(std::span<const std::byte> data);
  void text(std::string_view characters);  ///< length as u64, then the bytes
  void u8(uint8_t value) { little_endian(value, 1); }
  void u16(uint16_t value) { little_endian(value, 2); }
  void u32(uint32_t value) { little_endian(value, 4); }
  void u64(uint64_t value) { little_endian(value, 8); }
  void i64(int64_t value) { little_endian(static_cast<uint64_t>(value), 8); }
  void f64(double value) { little_endian(std::bit_cast<uint64_t>(value), 8); }

  /// 64 lower-case hexadecimal digits; ends the digest.
  std::string hex();

 private:
  void little_endian(uint64_t value, size_t size) {
    if (used_ + 8 > buffer_.size()) flush();
    if constexpr (std::endian::native == std::endian::little) {
      std::memcpy(buffer_.data() + used_, &value, 8);
    } else {
      for (size_t k = 0; k < 8; ++k) buffer_[used_ + k] = static_cast<std::byte>(value >> (8 * k));
    }
    used_ += size;  // the rest of the eight is overwritten next
  }
  void flush();

  struct Context;
  std::unique_ptr<Context> context_;
  std::array<std::byte, 4096> buffer_;
  size_t used_ = 0;
};

/// SHA-256 of a file's bytes as 64 hexadecimal digits. Throws input_error when it cannot be read.
std::string sha256_of_file(const std::string& path);

}  // namespace cuesta
