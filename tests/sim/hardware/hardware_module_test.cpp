#include <gtest/gtest.h>

#include <filesystem>

#include "models/common/error.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

// The program in a folder of its own, without the module of Verilated hardware or with a wrong one.

namespace cuesta {
namespace {

class HardwareModule : public testing::Test {
 protected:
  HardwareModule() {
    std::filesystem::copy_file(CUESTA_PROGRAM, folder_.path("cuesta"));
    std::filesystem::copy_file(built("cuesta_images.so"),
                               folder_.path("cuesta_images.so"));  // `run` writes planes
  }

  static std::filesystem::path built(const char* file) {
    return std::filesystem::path(CUESTA_PROGRAM).parent_path() / file;
  }

  /// Puts a file of the build tree's top folder beside the program, as the module.
  void place(const char* file) const {
    std::filesystem::copy_file(built(file), folder_.path("cuesta_hardware_sets.so"),
                               std::filesystem::copy_options::overwrite_existing);
  }
  ProgramResult verify_rtl() const {
    return run_program(folder_.path("cuesta"), {"verify", "rtl", "--ray-count", "10", "--sets", "tiny"},
                       folder_.path(""));
  }

  TemporaryFolder folder_;
};

TEST_F(HardwareModule, MissingNamesTheTargetThatBuildsIt) {
  const ProgramResult verify = verify_rtl();
  EXPECT_EQ(verify.code, static_cast<int>(ExitCode::kUsage));
  EXPECT_NE(verify.err.find("--target cuesta_hardware_sets"), std::string::npos) << verify.err;
  const ProgramResult run =
      run_program(folder_.path("cuesta"), {"run", "default", "--size", "8x8", "--set", "units.hmt_top=rtl"},
                  folder_.path(""));
  EXPECT_EQ(run.code, static_cast<int>(ExitCode::kUsage));
  EXPECT_NE(run.err.find("units.hmt_top = \"rtl\": "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("--target cuesta_hardware_sets"), std::string::npos) << run.err;
}

TEST_F(HardwareModule, OfOtherSourcesIsRefused) {
  place("cuesta_images.so");
  const ProgramResult verify = verify_rtl();
  EXPECT_EQ(verify.code, static_cast<int>(ExitCode::kResource));
  EXPECT_NE(verify.err.find("built from other sources than the program"), std::string::npos) << verify.err;
}

TEST_F(HardwareModule, BesideTheProgramIsLoaded) {
  place("cuesta_hardware_sets.so");
  EXPECT_EQ(verify_rtl().code, 0);
}

}  // namespace
}  // namespace cuesta
