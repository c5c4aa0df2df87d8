#pragma once

namespace cuesta {

/// Throws Error(kResource) when something printed to stdout is lost, as on a full disk. A reader that has gone
/// away, as `head` does, is no error.
void flush_standard_output();

}  // namespace cuesta
