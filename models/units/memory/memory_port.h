#pragma once

#include <vector>

#include "models/units/memory/memory_level.h"

namespace cuesta {

/// The way from height_l1 and result_writer to the memory level below them: puts requests into the order of arrival.
///
/// The level is asked in the order (cycle, pipeline, read before write). With one pipeline and no held-back ports the
/// requests come in that order and are passed on at once; otherwise they are kept and `serve_until` passes them on,
/// window by window.
class MemoryPort {
 public:
  /// `at_once`: for one pipeline without held-back ports, over a level that answers within `request`.
  MemoryPort(MemoryLevel& below, bool at_once) : below_(below), at_once_(at_once) {}

  /// Names the client, in the at-once form, that must not be overtaken by a read of the other.
  void set_writer(MemoryClient* writer) { writer_ = writer; }

  void send(const MemoryRequest& request) {
    if (!at_once_) {
      waiting_.push_back(request);
      return;
    }
    if (!request.write && writer_ != nullptr) writer_->catch_up(request.leaves);
    below_.request(request);
  }

  /// Passes on all requests that leave before `limit`.
  void serve_until(Cycle limit);

 private:
  MemoryLevel& below_;
  bool at_once_;
  MemoryClient* writer_ = nullptr;
  std::vector<MemoryRequest> waiting_;
};

}  // namespace cuesta
