# Language, floating point, warnings, sanitizers and ccache, for everything in the tree.
option(CUESTA_WERROR "Treat warnings as errors (./check does)" OFF)
option(CUESTA_SANITIZE "Address and undefined-behaviour sanitizers" OFF)
option(CUESTA_RTL "Verilate the hardware and hold the model against it" ON)
option(CUESTA_FUZZ "The readers under libFuzzer (needs clang): tests/fuzz/run" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)
endif()

if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(CUESTA_CCACHE ccache)
  if(CUESTA_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CUESTA_CCACHE}")
  endif()
endif()

# A fused multiply-add rounds once where two operations round twice: results would depend on the compiler.
add_compile_options(-ffp-contract=off)

if(CUESTA_SANITIZE)
  set(CUESTA_SANITIZER_FLAGS -fsanitize=address,undefined -fno-sanitize-recover=all)
  add_compile_options(${CUESTA_SANITIZER_FLAGS})
  add_link_options(${CUESTA_SANITIZER_FLAGS})
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()

add_library(cuesta_warnings INTERFACE)
target_compile_options(cuesta_warnings INTERFACE
    -Wall -Wextra -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough)
if(CUESTA_WERROR)
  target_compile_options(cuesta_warnings INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Plain -Wshadow of GCC reports enumerators of scoped enums too. -Wrestrict: GCC 12 reports overlapping copies
  # inside std::string at -O3 (GCC bug 105651).
  target_compile_options(cuesta_warnings INTERFACE -Wshadow=local -Wno-restrict)
  if(CUESTA_SANITIZE)
    # The sanitizers' own code confuses it, inside std::regex and std::function (GCC bug 105562).
    target_compile_options(cuesta_warnings INTERFACE -Wno-maybe-uninitialized)
  endif()
else()
  target_compile_options(cuesta_warnings INTERFACE -Wshadow)
endif()
