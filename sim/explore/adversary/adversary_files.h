#pragma once

#include <string>
#include <vector>

#include "reports/result_folder.h"
#include "sim/explore/adversary/adversary.h"

namespace cuesta {

/// How a case was found: what its files say of it.
struct AdversaryRecord {
  std::string algorithm;  ///< canonical
  Maximise maximise = Maximise::kSteps;
  std::string architecture;
  std::vector<std::string> settings;
  AddressMode address_mode = AddressMode::kWrap;
  AdversaryOptions options;
  double leaf_walk = 0;  ///< the leaf walk's score on the same case
};

/// Gives the command line that finds the case.
std::string finding_command(const AdversaryRecord& record, uint64_t tries);
/// Gives the command line that runs it from `folder`.
std::string reproducing_command(const AdversaryRecord& record, const std::string& folder);
/// Says in a sentence or two where that run shows the score, or where else it stands.
std::string place_of_score(const AdversaryRecord& record);

/// Writes map.png, rays.csv, scene.toml (all three: what `cuesta run` takes), case.toml and README.md. The
/// same case gives the same bytes.
void write_adversary_files(const AdversaryRecord& record, const AdversaryResult& result,
                           ResultFolder& folder);

}  // namespace cuesta
