# Run by the build (cmake -P): writes OUTPUT, a header with kSourcesKey, a digest of the files SOURCES and the names SETS.
cmake_minimum_required(VERSION 3.25)
set(text "${SETS}")
foreach(source IN LISTS SOURCES)
  file(SHA256 "${source}" digest)
  string(APPEND text " ${digest}")
endforeach()
string(SHA256 key "${text}")
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "#pragma once

namespace cuesta::rtl {

inline constexpr const char* kSourcesKey = \"${key}\";

}  // namespace cuesta::rtl
" @ONLY)
