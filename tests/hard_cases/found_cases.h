#pragma once

#include <string>
#include <vector>

namespace cuesta {

/// What `cuesta adversary` has found and somebody has kept: a folder of found/ as it wrote it.
struct FoundCase {
  std::string name;    ///< of the folder
  std::string folder;  ///< with its path
  std::string algorithm;
  std::string maximise;  ///< steps, cycles or error
  std::string architecture;
  std::vector<std::string> settings;
  std::string unit;  ///< of the score
  double score = 0;
  double leaf_walk = 0;  ///< what the leaf walk scores on the same case
  std::string command;   ///< that found it
};

/// In the order of their names. Throws usage_error for a folder that holds something else.
std::vector<FoundCase> found_cases();

/// The section of README.md.
std::string found_table();

}  // namespace cuesta
