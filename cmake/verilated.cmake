# Hardware as a C++ class: the RTL through Verilator.
find_package(verilator 5.006 REQUIRED HINTS /usr/share/verilator)

# cuesta_verilated(NAME TOP module PREFIX V... SOURCES a.sv ... [PARAMETERS N=1 ...])
# A static library with the class PREFIX, whose header is PREFIX.h.
function(cuesta_verilated name)
  cmake_parse_arguments(ARG "" "TOP;PREFIX" "SOURCES;PARAMETERS" ${ARGN})
  cuesta_no_leftovers(cuesta_verilated ${name})
  list(TRANSFORM ARG_SOURCES PREPEND "${PROJECT_SOURCE_DIR}/rtl/")
  list(TRANSFORM ARG_PARAMETERS PREPEND "-G")
  add_library(${name} STATIC)
  verilate(${name} SOURCES "${PROJECT_SOURCE_DIR}/rtl/waivers.vlt" ${ARG_SOURCES} TOP_MODULE ${ARG_TOP} PREFIX ${ARG_PREFIX}
      INCLUDE_DIRS "${PROJECT_SOURCE_DIR}/rtl"
      VERILATOR_ARGS -Wall --x-assign unique --x-initial unique ${ARG_PARAMETERS}
      OPT_FAST -O3 -fno-tree-vectorize OPT_GLOBAL -O3)
  # Generated code is not held to the project's warnings.
  target_compile_options(${name} PRIVATE -w)
  target_include_directories(${name} SYSTEM INTERFACE /usr/share/verilator/include)
endfunction()
