# Hardware as a C++ class: the RTL through Verilator.
find_package(verilator 5.006 REQUIRED HINTS /usr/share/verilator)

set(CUESTA_TRAVERSE_SV "${PROJECT_SOURCE_DIR}/rtl/traversal/traverse.sv" CACHE FILEPATH
    "The module traverse to verilate: your own with the same ports is held against the model in its place")
set(CUESTA_HMT_TOP_SOURCES
    traversal/ray_setup_engine.sv traversal/ray_setup.sv "${CUESTA_TRAVERSE_SV}" memory/height_l1.sv hmt_top.sv)

# cuesta_verilated(NAME TOP module PREFIX V... SOURCES a.sv ... [PARAMETERS N=1 ...] [WAVES])
# A static library with the class PREFIX, whose header is PREFIX.h. SOURCES: relative to rtl/. WAVES: it can write its signals (FST).
function(cuesta_verilated name)
  cmake_parse_arguments(ARG "WAVES" "TOP;PREFIX" "SOURCES;PARAMETERS" ${ARGN})
  cuesta_no_leftovers(cuesta_verilated ${name})
  set(sources)
  foreach(source IN LISTS ARG_SOURCES)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${PROJECT_SOURCE_DIR}/rtl")
    list(APPEND sources "${source}")
  endforeach()
  list(TRANSFORM ARG_PARAMETERS PREPEND "-G")
  set(waves)
  if(ARG_WAVES)
    set(waves TRACE_FST)
  endif()
  add_library(${name} STATIC)
  verilate(${name} SOURCES "${PROJECT_SOURCE_DIR}/rtl/waivers.vlt" ${sources}
      TOP_MODULE ${ARG_TOP} PREFIX ${ARG_PREFIX} ${waves}
      INCLUDE_DIRS "${PROJECT_SOURCE_DIR}/rtl"
      VERILATOR_ARGS -Wall --x-assign unique --x-initial unique ${ARG_PARAMETERS}
      OPT_FAST -O3 -fno-tree-vectorize OPT_GLOBAL -O3)
  # Generated code is not held to the project's warnings.
  target_compile_options(${name} PRIVATE -w)
  target_include_directories(${name} SYSTEM INTERFACE /usr/share/verilator/include)
endfunction()
