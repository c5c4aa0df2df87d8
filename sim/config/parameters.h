#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/units/architecture.h"

namespace cuesta {

/// A parameter of a whole architecture: a row of a unit's table, reached through its section. The list of all of them
/// is what files, `--set`, the resolved configuration, `cuesta list parameters` and the documentation use.
struct Parameter : ParameterRow<Architecture> {
  std::string_view section() const { return path.substr(0, path.find('.')); }
  std::string_view key() const { return path.substr(path.find('.') + 1); }
  /// "a power of two from 16 to 1024", "one of fixed, float, double".
  std::string accepted() const;
  /// A value as it is written in a file: 4, "morton".
  std::string text(int64_t value) const;
};

/// All parameters, section after section along the data's way.
std::span<const Parameter> parameters();

/// Section names in the table's order.
std::span<const std::string_view> parameter_sections();

/// nullptr when there is none of that path.
const Parameter* find_parameter(std::string_view path);

/// Why a run does not use this parameter, as the end of a sentence; empty when it does.
std::string why_unused(const Parameter& parameter, const Architecture& architecture, bool with_time);

/// What no single range can say: sizes that must divide each other, queues that must hold a pipe.
/// One sentence per contradiction, each naming its keys; empty when there is none.
std::vector<std::string> contradictions(const Architecture& architecture);

}  // namespace cuesta
