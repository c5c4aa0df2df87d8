# One function for each pattern that repeats in the folders.

# cuesta_library(NAME SOURCES a.cpp ... [DEPENDS target ...] [PRIVATE_DEPENDS target ...])
# A static library (header-only without SOURCES); includes are written from the project's root.
function(cuesta_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  cuesta_no_leftovers(cuesta_library ${name})
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_SOURCES})
    target_include_directories(${name} PUBLIC "${PROJECT_SOURCE_DIR}")
    target_link_libraries(${name} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS} cuesta_warnings)
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE "${PROJECT_SOURCE_DIR}")
    target_link_libraries(${name} INTERFACE ${ARG_DEPENDS})
  endif()
endfunction()

# cuesta_program(NAME SOURCES ... [DEPENDS ...]): an executable at the top of the build folder.
function(cuesta_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  cuesta_no_leftovers(cuesta_program ${name})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} cuesta_warnings)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}")
endfunction()

# cuesta_test(NAME LABEL value|cycle|rtl|machine|hard SOURCES ... [DEPENDS ...] [TIMEOUT seconds] [SYSTEMC])
# A GoogleTest program; every TEST is one CTest test, in a process of its own, started in the project's root.
# TIMEOUT (default 300) is per TEST. SYSTEMC: the kernel's main() runs the tests from sc_main.
function(cuesta_test name)
  cmake_parse_arguments(ARG "SYSTEMC" "LABEL;TIMEOUT" "SOURCES;DEPENDS" ${ARGN})
  cuesta_no_leftovers(cuesta_test ${name})
  if(NOT ARG_LABEL MATCHES "^(value|cycle|rtl|machine|hard)$")
    message(FATAL_ERROR "cuesta_test(${name}): LABEL is '${ARG_LABEL}'; accepted: value, cycle, rtl, machine, hard.")
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  if(ARG_SYSTEMC)
    list(APPEND ARG_SOURCES "${PROJECT_SOURCE_DIR}/tests/support/systemc_main.cpp")
    list(APPEND ARG_DEPENDS GTest::gtest cuesta_systemc)
  else()
    list(APPEND ARG_DEPENDS GTest::gtest_main)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} GTest::gtest cuesta_warnings)
  # `if (...) EXPECT_EQ(...)` is not ambiguous: GoogleTest's macros begin with a switch for that.
  target_compile_options(${name} PRIVATE -Wno-dangling-else)
  if(NOT TARGET tests_${ARG_LABEL})
    add_custom_target(tests_${ARG_LABEL})  # every test program of the label
  endif()
  add_dependencies(tests_${ARG_LABEL} ${name})
  gtest_discover_tests(${name}
      WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
      DISCOVERY_MODE PRE_TEST
      DISCOVERY_TIMEOUT 60
      PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT})
endfunction()

# cuesta_benchmark(NAME SOURCES ... [DEPENDS ...]): a Google Benchmark program; built with everything, run by hand.
function(cuesta_benchmark name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  cuesta_no_leftovers(cuesta_benchmark ${name})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${ARG_DEPENDS} benchmark::benchmark cuesta_warnings)
endfunction()

macro(cuesta_no_leftovers function name)
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${function}(${name}): unknown arguments: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
endmacro()
