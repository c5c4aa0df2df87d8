#pragma once

#include <string>
#include <vector>

namespace cuesta {

/// A table's rows, the first its heads.
using Rows = std::vector<std::vector<std::string>>;

/// Prints columns as wide as their widest cell, two spaces between; the last one is not filled up.
void print_rows(const Rows& rows);

/// Prints `cuesta list algorithms`: schedules, parts, how to write one's own, and the approximate ones.
void list_algorithms();

}  // namespace cuesta
