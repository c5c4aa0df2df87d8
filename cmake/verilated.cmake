# Hardware as a C++ class: the RTL through Verilator.
find_package(verilator 5.006 REQUIRED HINTS /usr/share/verilator)

set(CUESTA_HMT_TOP_SOURCES
    traversal/ray_setup_engine.sv traversal/ray_setup.sv traversal/traverse.sv memory/height_l1.sv hmt_top.sv)

# cuesta_verilated(NAME TOP module PREFIX V... SOURCES a.sv ... [PARAMETERS N=1 ...] [WAVES])
# A static library with the class PREFIX, whose header is PREFIX.h. WAVES: it can write its signals (FST).
function(cuesta_verilated name)
  cmake_parse_arguments(ARG "WAVES" "TOP;PREFIX" "SOURCES;PARAMETERS" ${ARGN})
  cuesta_no_leftovers(cuesta_verilated ${name})
  list(TRANSFORM ARG_SOURCES PREPEND "${PROJECT_SOURCE_DIR}/rtl/")
  list(TRANSFORM ARG_PARAMETERS PREPEND "-G")
  set(waves)
  if(ARG_WAVES)
    set(waves TRACE_FST)
  endif()
  add_library(${name} STATIC)
  verilate(${name} SOURCES "${PROJECT_SOURCE_DIR}/rtl/waivers.vlt" ${ARG_SOURCES}
      TOP_MODULE ${ARG_TOP} PREFIX ${ARG_PREFIX} ${waves}
      INCLUDE_DIRS "${PROJECT_SOURCE_DIR}/rtl"
      VERILATOR_ARGS -Wall --x-assign unique --x-initial unique ${ARG_PARAMETERS}
      OPT_FAST -O3 -fno-tree-vectorize OPT_GLOBAL -O3)
  # Generated code is not held to the project's warnings.
  target_compile_options(${name} PRIVATE -w)
  target_include_directories(${name} SYSTEM INTERFACE /usr/share/verilator/include)
endfunction()
