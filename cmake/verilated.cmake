# Hardware as a C++ class: the RTL through Verilator.
find_package(verilator 5.006 REQUIRED HINTS /usr/share/verilator)

set(CUESTA_TRAVERSE_SV "${PROJECT_SOURCE_DIR}/rtl/traverse/traverse.sv" CACHE FILEPATH
    "The module traverse to verilate: your own with the same ports is held against the model in its place")
set(CUESTA_OTHER_TRAVERSE OFF)
if(NOT CUESTA_TRAVERSE_SV STREQUAL "${PROJECT_SOURCE_DIR}/rtl/traverse/traverse.sv")
  set(CUESTA_OTHER_TRAVERSE ON)
  if(NOT EXISTS "${CUESTA_TRAVERSE_SV}")
    message(FATAL_ERROR "CUESTA_TRAVERSE_SV: there is no ${CUESTA_TRAVERSE_SV}; "
        "-U CUESTA_TRAVERSE_SV takes rtl/traverse/traverse.sv again.")
  endif()
  message(STATUS "traverse of hmt_top: ${CUESTA_TRAVERSE_SV}; -U CUESTA_TRAVERSE_SV takes rtl/traverse/traverse.sv again")
endif()
set(CUESTA_HMT_TOP_SOURCES
    ray_setup/ray_setup_engine.sv ray_setup/ray_setup.sv "${CUESTA_TRAVERSE_SV}" height_l1/height_l1.sv hmt_top.sv)

set(CUESTA_RTL_ASSERTIONS
    hmt_top_assertions.sv ray_setup/ray_setup_assertions.sv traverse/traverse_assertions.sv
    height_l1/height_l1_assertions.sv assertions.sv)

option(CUESTA_RTL_COVERAGE "Count the lines that Verilated hardware runs through: tests/rtl/coverage" OFF)

# Verilator's own code, once for all hardware: verilate() would compile it again for each.
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)
if(NOT TARGET verilator_runtime)
  set(verilator_include /usr/share/verilator/include)
  add_library(verilator_runtime STATIC "${verilator_include}/verilated.cpp" "${verilator_include}/verilated_fst_c.cpp"
      "${verilator_include}/verilated_threads.cpp")
  target_include_directories(verilator_runtime SYSTEM PUBLIC "${verilator_include}" "${verilator_include}/vltstd")
  if(CUESTA_RTL_COVERAGE)
    target_sources(verilator_runtime PRIVATE "${verilator_include}/verilated_cov.cpp")
  endif()
  target_compile_options(verilator_runtime PRIVATE -O3 -w)
  set_target_properties(verilator_runtime PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
  target_link_libraries(verilator_runtime PUBLIC Threads::Threads ZLIB::ZLIB)
endif()

option(CUESTA_RTL_ASSERT "Verilate all hardware with its assertions, not only what is for tests" OFF)
set(CUESTA_RTL_OPTIMISE -O3 CACHE STRING "How Verilated code is optimised")

# cuesta_verilated(NAME TOP module PREFIX V... SOURCES a.sv ... [PARAMETERS N=1 ...] [WAVES] [ASSERT])
# A static library with the class PREFIX, whose header is PREFIX.h. SOURCES: relative to rtl/. WAVES: it can write its
# signals (FST). ASSERT: with the assertions (of a user's traverse: none); one that does not hold ends the program.
function(cuesta_verilated name)
  cmake_parse_arguments(ARG "WAVES;ASSERT" "TOP;PREFIX" "SOURCES;PARAMETERS" ${ARGN})
  cuesta_no_leftovers(cuesta_verilated ${name})
  set(assert)
  if(ARG_ASSERT OR CUESTA_RTL_ASSERT)
    set(assert --assert)
    if(CUESTA_OTHER_TRAVERSE)
      list(APPEND assert +define+HMT_OTHER_TRAVERSE)
    endif()
    if(NOT ARG_TOP MATCHES "_assertions$")
      list(APPEND ARG_SOURCES ${CUESTA_RTL_ASSERTIONS})
    endif()
  endif()
  set(coverage)
  if(CUESTA_RTL_COVERAGE)
    # Split or reordered blocks count by the values that local variables had before: Verilator 5.006.
    set(coverage --coverage-line -fno-reorder)
  endif()
  set(sources)
  foreach(source IN LISTS ARG_SOURCES)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${PROJECT_SOURCE_DIR}/rtl")
    list(APPEND sources "${source}")
  endforeach()
  list(TRANSFORM ARG_PARAMETERS PREPEND "-G")
  # A user's own module is not held to this project's lint.
  set(lint -Wall)
  if(CUESTA_OTHER_TRAVERSE)
    set(lint -Wall -Wno-fatal -Wno-DECLFILENAME)
  endif()
  set(waves)
  if(ARG_WAVES)
    set(waves TRACE_FST)
  endif()
  # The list of what Verilator read last; where a file of it has gone, Verilator has to run again.
  set(listed "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${name}.dir/${ARG_PREFIX}.dir/${ARG_PREFIX}_copy.cmake")
  if(EXISTS "${listed}")
    file(STRINGS "${listed}" files REGEX "^set\\(${ARG_PREFIX}_DEPS ")
    string(REGEX MATCHALL "\"[^\"]+\"" files "${files}")
    foreach(file IN LISTS files)
      string(REPLACE "\"" "" file "${file}")
      if(NOT EXISTS "${file}")
        file(REMOVE "${listed}")
      endif()
    endforeach()
  endif()
  add_library(${name} STATIC)
  verilate(${name} SOURCES "${PROJECT_SOURCE_DIR}/rtl/waivers.vlt" ${sources}
      TOP_MODULE ${ARG_TOP} PREFIX ${ARG_PREFIX} ${waves}
      INCLUDE_DIRS "${PROJECT_SOURCE_DIR}/rtl"
      # A process in pieces reads registers that another piece has written: -fno-split saves their copies.
      VERILATOR_ARGS ${lint} ${assert} ${coverage} --x-assign unique --x-initial unique -fno-split ${ARG_PARAMETERS}
      OPT_FAST ${CUESTA_RTL_OPTIMISE} -fno-tree-vectorize OPT_GLOBAL ${CUESTA_RTL_OPTIMISE})
  get_target_property(with_runtime ${name} SOURCES)
  list(FILTER with_runtime EXCLUDE REGEX "^/usr/share/verilator/include/")
  set_target_properties(${name} PROPERTIES SOURCES "${with_runtime}")
  target_link_libraries(${name} PUBLIC verilator_runtime)
  # For the module of the hardware's sets.
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
  # Generated code is not held to the project's warnings.
  target_compile_options(${name} PRIVATE -w)
endfunction()
