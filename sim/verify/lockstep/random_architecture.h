#pragma once

#include "models/common/random.h"
#include "models/units/architecture.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta {

/// 1 to 4 pipelines; queues, caches and limits down to 1, small ones often; clock ratios; any arithmetic, order and
/// layout. No contradictions.
Architecture random_architecture(Random& random);

/// Chances of a stall for each port: none, some, now and then nearly always.
PortStalls random_stalls(Random& random);

}  // namespace cuesta
