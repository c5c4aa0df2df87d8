#pragma once

#include <string>

#include "models/units/dram/parameters.h"
#include "models/units/height_l1/parameters.h"
#include "models/units/hit_queue/parameters.h"
#include "models/units/machine_parameters.h"
#include "models/units/ray_dispatch/parameters.h"
#include "models/units/ray_setup/parameters.h"
#include "models/units/result_writer/parameters.h"
#include "models/units/traverse/parameters.h"

namespace cuesta {

/// Everything that an architect turns. Sections of an architecture file carry the unit names.
struct Architecture {
  std::string name = "mobile";
  MachineParameters machine;
  RayDispatchParameters ray_dispatch;
  RaySetupParameters ray_setup;
  TraverseParameters traverse;
  HeightL1Parameters height_l1;
  HitQueueParameters hit_queue;
  ResultWriterParameters result_writer;
  DramParameters dram;
  TexelParameters texels;
  UnitParameters units;
};

}  // namespace cuesta
