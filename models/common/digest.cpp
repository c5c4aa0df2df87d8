#include "models/common/digest.h"

#include <openssl/evp.h>

#include <array>
#include <cstdio>

#include "models/common/error.h"

namespace cuesta {

struct Digest::Context {
  EVP_MD_CTX* evp = EVP_MD_CTX_new();

  Context() {
    if (evp == nullptr || EVP_DigestInit_ex(evp, EVP_sha256(), nullptr) != 1) {
      throw Error(ExitCode::kInternal, "SHA-256 cannot be set up in this build's OpenSSL.");
    }
  }
  ~Context() { EVP_MD_CTX_free(evp); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

Digest::Digest() : context_(std::make_unique<Context>()) {}
Digest::~Digest() = default;

void Digest::flush() {
  EVP_DigestUpdate(context_->evp, buffer_.data(), used_);
  used_ = 0;
}

void Digest::bytes(std::span<const std::byte> data) {
  flush();
  EVP_DigestUpdate(context_->evp, data.data(), data.size());
}

void Digest::text(std::string_view characters) {
  u64(characters.size());
  bytes(std::as_bytes(std::span(characters)));
}

std::string Digest::hex() {
  flush();
  unsigned char hash[EVP_MAX_MD_SIZE];
  unsigned size = 0;
  EVP_DigestFinal_ex(context_->evp, hash, &size);
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
