#pragma once

#include "models/architecture.h"
#include "models/common/port_stalls.h"
#include "models/common/random.h"

namespace cuesta {

/// 1 to 4 pipelines; queues, caches and limits down to 1, small ones often; clock ratios; any arithmetic, order and
/// layout. No contradictions.
Architecture random_architecture(Random& random);

/// Chances of a stall for each port: none, some, now and then nearly always.
PortStalls random_stalls(Random& random);

}  // namespace cuesta
