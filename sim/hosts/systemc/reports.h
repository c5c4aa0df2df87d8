#pragma once

#include <systemc>

#include "models/common/error.h"

namespace cuesta::systemc {

/// Makes SystemC's reports the program's own: information is dropped, a warning is one line on stderr (nothing when
/// `quiet`), an error or a fatal error is thrown and ends the simulation, never the process.
void install_report_handler(bool quiet);

/// The Error that a report stands for. Message types cuesta/usage, cuesta/input, cuesta/no_progress, cuesta/mismatch
/// and cuesta/resource carry the exit code of that name; any other is kInternal: a fault of a model or of ours.
Error error_of(const sc_core::sc_report& report);

}  // namespace cuesta::systemc
