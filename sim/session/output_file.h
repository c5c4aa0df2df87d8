#pragma once

#include <string>

namespace cuesta {

/// Throws usage_error when something of that name is there and `force` is false: no verb writes over a file unasked.
void refuse_existing(const std::string& path, bool force);

}  // namespace cuesta
