#pragma once

#include <stdexcept>
#include <string>

namespace cuesta {

/// Exit codes of the command line; every `Error` carries the one that it ends the program with.
enum class ExitCode : int {
  kOk = 0,
  kInternal = 1,    ///< a fault of ours
  kUsage = 2,       ///< command line or configuration
  kInput = 3,       ///< input data: image, ray trace, heights
  kNoProgress = 4,  ///< the simulated machine stopped moving
  kMismatch = 5,    ///< a verification found a difference
  kResource = 6,    ///< memory, disk, a size beyond a stated limit
  kIncomplete = 7,  ///< interrupted; what was finished is kept and labelled partial
  kTryAgain = 75,   ///< a re-queue may help
};

/// An error that a user can act on. `what()` is one whole sentence: what was found, where, and what is accepted.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

inline Error usage_error(const std::string& sentence) { return {ExitCode::kUsage, sentence}; }
inline Error input_error(const std::string& sentence) { return {ExitCode::kInput, sentence}; }

}  // namespace cuesta
