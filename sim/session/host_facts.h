#pragma once

#include <string>

namespace cuesta {

// What is true of this host now. It goes into manifests and times.json alone, never into results.

std::string host_name();       ///< "unknown" where the system does not say
std::string processor_name();  ///< as /proc/cpuinfo names the first one
std::string load_average();    ///< the line of /proc/loadavg
/// How manifests write a time of day: ISO 8601, in UTC.
inline constexpr const char* kTimeOfDay = "%Y-%m-%dT%H:%M:%SZ";
/// The time of day, UTC, as strftime writes it.
std::string time_now(const char* format);

}  // namespace cuesta
