#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cuesta {

/// A map of floats as a file holds it: what the loader makes of it.
struct HardFile {
  std::string_view name;
  std::string_view holds;
  std::string_view reason;
  std::vector<float> heights;  ///< 4 x 4
  std::string_view nodata;     ///< the marker that is given; empty: none
  std::string_view refused;    ///< words of the sentence; empty: accepted
};
std::span<const HardFile> hard_files();

/// README.md of this folder, from the tables and from what lies in found/.
std::string catalogue();

}  // namespace cuesta
