#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cuesta::tests {

/// Where `value` breaks `schema`, one line each; empty when it is valid. Knows the keywords of JSON Schema 2020-12
/// that our schemas use; a keyword that it does not know is reported, never skipped.
std::vector<std::string> schema_faults(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace cuesta::tests
