#include "models/units/memory/memory_port.h"

#include <algorithm>
#include <tuple>

namespace cuesta {

void MemoryPort::serve_until(Cycle limit) {
  if (!waiting_.empty()) {
    std::sort(waiting_.begin(), waiting_.end(), [](const MemoryRequest& a, const MemoryRequest& b) {
      return std::tie(a.leaves, a.pipeline, a.write) < std::tie(b.leaves, b.pipeline, b.write);
    });
    size_t served = 0;
    while (served < waiting_.size() && waiting_[served].leaves < limit) below_.request(waiting_[served++]);
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(served));
  }
  below_.settle(limit);
}

}  // namespace cuesta
