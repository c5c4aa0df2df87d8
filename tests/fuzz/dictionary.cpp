#include <cstdio>
#include <string_view>

#include "models/heightmap/generator.h"
#include "sim/config/parameters.h"

// Prints libFuzzer's dictionary of `scene` or `architecture`: the words of the tables that their readers use.
// The scenes and machines of the tree, which are seeds, hold the rest.
namespace {

void print(std::string_view word) {
  if (!word.empty()) std::printf("\"%.*s\"\n", static_cast<int>(word.size()), word.data());
}

}  // namespace

int main(int count, char** arguments) {
  using namespace cuesta;
  const std::string_view target = count == 2 ? arguments[1] : "";
  if (target == "architecture") {
    for (const Parameter& parameter : parameters()) {
      print(parameter.path);
      print(parameter.key());
      for (std::string_view name : parameter.names) print(name);
    }
    for (std::string_view section : parameter_sections()) print(section);
  } else if (target == "scene") {
    for (const MapKind& kind : map_kinds()) print(kind.name);
  } else {
    std::fprintf(stderr, "fuzz_dictionary: accepted are scene, architecture.\n");
    return 2;
  }
  return 0;
}
