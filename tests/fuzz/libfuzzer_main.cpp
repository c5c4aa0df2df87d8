#include "tests/fuzz/targets.h"

// CUESTA_FUZZ_TARGET: the name of a function of targets.h; libFuzzer's own main() calls this.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  cuesta::fuzz::CUESTA_FUZZ_TARGET({data, size});
  return 0;
}
