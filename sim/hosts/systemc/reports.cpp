#include "sim/hosts/systemc/reports.h"

#include <cstdio>
#include <string>
#include <string_view>

namespace cuesta::systemc {

namespace {

bool quiet_warnings = false;

void handle(const sc_core::sc_report& report, const sc_core::sc_actions&) {
  switch (report.get_severity()) {
    case sc_core::SC_INFO:
      return;
    case sc_core::SC_WARNING:
      if (!quiet_warnings) {
        std::fprintf(stderr, "cuesta: SystemC warns at %s: %s: %s\n",
                     sc_core::sc_time_stamp().to_string().c_str(), report.get_msg_type(), report.get_msg());
      }
      return;
    default:
      throw report;
  }
}

struct Row {
  std::string_view type;
  ExitCode code;
};

constexpr Row kCodes[] = {
    {"cuesta/usage", ExitCode::kUsage},
    {"cuesta/input", ExitCode::kInput},
    {"cuesta/no_progress", ExitCode::kNoProgress},
    {"cuesta/mismatch", ExitCode::kMismatch},
    {"cuesta/resource", ExitCode::kResource},
};

}  // namespace

void install_report_handler(bool quiet) {
  quiet_warnings = quiet;
  sc_core::sc_report_handler::set_handler(handle);
}

Error error_of(const sc_core::sc_report& report) {
  const std::string_view type = report.get_msg_type();
  for (const Row& row : kCodes) {
    if (row.type == type) return {row.code, report.get_msg()};
  }
  return {ExitCode::kInternal, "SystemC stopped at " + sc_core::sc_time_stamp().to_string() + ": " +
                                   std::string(type) + ": " + report.get_msg() + "."};
}

}  // namespace cuesta::systemc
