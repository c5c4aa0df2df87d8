#include "models/common/digest.h"

#include <openssl/evp.h>

#include <array>
#include <cstdio>
#include <cstring>

#include "models/common/error.h"

namespace cuesta {

struct Digest::State {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  std::array<unsigned char, 1 << 16> buffer;
  size_t used = 0;

  State() {
    if (context == nullptr || EVP_DigestInit_ex(context, EVP_sha256(), nullptr) != 1) {
      throw Error(ExitCode::kInternal, "SHA-256 cannot be set up in this build's OpenSSL.");
    }
  }
  ~State() { EVP_MD_CTX_free(context); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void flush() {
    EVP_DigestUpdate(context, buffer.data(), used);
    used = 0;
  }
};

Digest::Digest() : state_(std::make_unique<State>()) {}
Digest::~Digest() = default;

void Digest::bytes(std::span<const std::byte> data) {
  state_->flush();
  EVP_DigestUpdate(state_->context, data.data(), data.size());
}

void Digest::text(std::string_view characters) {
  u64(characters.size());
  bytes(std::as_bytes(std::span(characters)));
}

void Digest::little_endian(uint64_t value, int size) {
  State& state = *state_;
  if (state.used + 8 > state.buffer.size()) state.flush();
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(state.buffer.data() + state.used, &value, 8);  // the rest of the eight is overwritten next
  } else {
    for (int k = 0; k < size; ++k)
      state.buffer[state.used + static_cast<size_t>(k)] = static_cast<unsigned char>(value >> (8 * k));
  }
  state.used += static_cast<size_t>(size);
}

std::string Digest::hex() {
  state_->flush();
  unsigned char hash[EVP_MAX_MD_SIZE];
  unsigned size = 0;
  EVP_DigestFinal_ex(state_->context, hash, &size);
  static const char digits[] = "0123456789abcdef";
  std::string text;
  for (unsigned k = 0; k < size; ++k) {
    text += digits[hash[k] >> 4];
    text += digits[hash[k] & 15];
  }
  return text;
}

std::string sha256_of_file(const std::string& path) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw input_error("'" + path + "' cannot be opened for reading.");
  Digest digest;
  std::array<std::byte, 1 << 16> block;
  size_t got;
  while ((got = std::fread(block.data(), 1, block.size(), file.get())) > 0) digest.bytes({block.data(), got});
  if (std::ferror(file.get()) != 0) throw input_error("'" + path + "' cannot be read.");
  return digest.hex();
}

}  // namespace cuesta
