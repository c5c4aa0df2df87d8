#pragma once

#include <vector>

#include "reports/result.h"

namespace cuesta::tests {

struct ExampleShape {
  int width = 24, height = 16;  ///< of the planes
  int pipelines = 2;
  std::vector<const char*> scenes = {"rocks-front"};
  std::vector<const char*> algorithms = {"dda", "oh2006", "yun2013"};
  bool timed = true;  ///< false: what functional fidelity counts
};

/// A result with made-up but consistent numbers: slots add up to cycles, planes + nobody to totals.
Result example_result(const ExampleShape& shape = {});

}  // namespace cuesta::tests
