# cuesta_systemc: what includes SystemC links this. Debian's library is a C++17 build, and its header makes the
# name of a link-time symbol from the language level: without SC_CPLUSPLUS a C++20 program does not link.
pkg_check_modules(SystemC REQUIRED IMPORTED_TARGET GLOBAL systemc)
add_library(cuesta_systemc INTERFACE)
target_link_libraries(cuesta_systemc INTERFACE PkgConfig::SystemC)
target_compile_definitions(cuesta_systemc INTERFACE SC_CPLUSPLUS=201703L SC_INCLUDE_DYNAMIC_PROCESSES)

if(NOT DEFINED CUESTA_SYSTEMC_LINKS)
  try_compile(CUESTA_SYSTEMC_LINKS
      "${PROJECT_BINARY_DIR}/systemc_probe" SOURCES "${CMAKE_CURRENT_LIST_DIR}/systemc_probe.cpp"
      COMPILE_DEFINITIONS -DSC_CPLUSPLUS=201703L
      LINK_LIBRARIES PkgConfig::SystemC
      CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON
      OUTPUT_VARIABLE cuesta_systemc_output)
  if(NOT CUESTA_SYSTEMC_LINKS)
    unset(CUESTA_SYSTEMC_LINKS CACHE)
    message(FATAL_ERROR
        "SystemC ${SystemC_VERSION} was found by pkg-config, but a C++20 program with SC_CPLUSPLUS=201703L does not "
        "link against it. Accepted: a C++17 build of SystemC, such as Debian 12's libsystemc-dev 2.3.4. "
        "The linker said:\n${cuesta_systemc_output}")
  endif()
endif()
