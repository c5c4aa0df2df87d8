#pragma once

#include <string>

namespace cuesta {

/// Reads "512x256" or "512" (square): texels, at most `longest` on a side. Throws usage_error.
void parse_map_size(const std::string& text, int& width, int& height, int longest = 16384);

}  // namespace cuesta
