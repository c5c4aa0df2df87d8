#include <string>
#include <vector>

#include "models/common/error.h"
#include "sim/config/architecture_file.h"
#include "sim/config/parameters.h"
#include "tests/fuzz/scratch_file.h"

void cuesta::fuzz::architecture(Bytes bytes) {
  constexpr std::string_view kMark = "\n--set\n";
  std::string file = text_of(bytes), settings_text;
  if (const size_t mark = file.find(kMark); mark != std::string::npos) {
    settings_text = file.substr(mark + kMark.size());
    file.resize(mark + 1);
  }
  std::vector<std::string> settings;
  for (size_t at = 0; at < settings_text.size();) {
    const size_t end = std::min(settings_text.find('\n', at), settings_text.size());
    settings.push_back(settings_text.substr(at, end - at));
    at = end + 1;
  }
  try {
    const ResolvedArchitecture machine =
        resolve_architecture(scratch_file("machine.toml", bytes_of(file)), settings, true);
    const std::string written = machine.toml(true);
    const ResolvedArchitecture again =
        resolve_architecture(scratch_file("resolved.toml", bytes_of(written)), {}, true);
    for (const Parameter& parameter : parameters()) {
      require(parameter.get(machine.architecture) == parameter.get(again.architecture),
              "a resolved configuration reads back as the same machine");
    }
  } catch (const Error&) {
  }
}
