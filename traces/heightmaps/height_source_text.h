#pragma once

#include <string>

#include "traces/heightmaps/image_reader.h"

namespace cuesta {

/// Heights on a command line: FILE, FILE:CHANNEL, and then any of ",values=depth", ",bits=12", ",normalise=min_max",
/// ",range=-4.5..921", ",nodata=-9999" and ",raw=1024x1024:uint16:little". A file of the whole name goes first, so
/// that any name can be given. Throws usage_error with what is accepted.
HeightSource parse_height_source(const std::string& text);

// Their values one by one, for options and keys; `origin` names the option in the sentence. All throw usage_error.

/// "height" or "depth": true for depth.
bool parse_depth(const std::string& text, const std::string& origin);
/// "auto", "none" or "min_max".
Normalisation parse_normalisation(const std::string& text, const std::string& origin);
/// "-4.5..921" or "-4.5,921".
void parse_height_range(const std::string& text, const std::string& origin, double& low, double& high);
/// "-9999", "nan", "inf" or "-inf".
double parse_nodata(const std::string& text, const std::string& origin);

}  // namespace cuesta
