#pragma once

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "tests/fuzz/targets.h"
#include "tests/support/temporary_folder.h"

namespace cuesta::fuzz {

/// The path of a file of that name with these bytes, in a folder that goes with the process.
inline std::string scratch_file(const std::string& name, Bytes bytes) {
  static const TemporaryFolder folder;
  const std::string path = folder.path(name);
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error("the scratch file cannot be written");
  return path;
}

inline std::string text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

inline Bytes bytes_of(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

/// A claim that every input must keep; a broken one is a finding.
inline void require(bool holds, const char* claim) {
  if (!holds) throw std::logic_error(claim);
}

}  // namespace cuesta::fuzz
