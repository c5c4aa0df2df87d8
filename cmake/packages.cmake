# Everything that the tree takes from Debian; ./setup installs it. Nothing is fetched at configure or build time.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)   # OpenSSL::Crypto (SHA-256)
find_package(zstd REQUIRED CONFIG)                 # zstd::libzstd_shared
pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET GLOBAL libxxhash)  # PkgConfig::xxhash
find_package(tomlplusplus REQUIRED CONFIG)         # headers alone, without its target
find_package(nlohmann_json REQUIRED CONFIG)        # nlohmann_json::nlohmann_json
find_package(CLI11 REQUIRED CONFIG)                # CLI11::CLI11
find_package(fmt REQUIRED CONFIG)                  # fmt::fmt
find_package(Boost 1.74 REQUIRED)                  # Boost::headers (Multiprecision, for the oracle)
include(openimageio)                               # OpenImageIO::OpenImageIO
include(systemc)                                   # cuesta_systemc

if(BUILD_TESTING)
  find_package(GTest REQUIRED CONFIG)              # GTest::gtest, GTest::gtest_main, GTest::gmock
  include(GoogleTest)
  find_package(benchmark REQUIRED CONFIG)          # benchmark::benchmark_main
endif()
