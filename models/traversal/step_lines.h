#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "models/heightmap/texel_layout.h"
#include "models/traversal/fetch.h"

// A ray's steps as units in time see them: the numbers of the memory lines that they read, in order. Line numbers are
// below 2^30; the two bits above mark what a single line cannot say.

namespace cuesta {

inline constexpr uint32_t kMoreLines = uint32_t{1} << 31;  ///< the step is not done with this line
inline constexpr uint32_t kKeptStep = uint32_t{1}
                                      << 30;  ///< a step that reads nothing, in the place of a line
/// A slot of arithmetic that reads nothing, before the lines of its step.
inline constexpr uint32_t kComputeSlot = kMoreLines | kKeptStep;
inline constexpr uint32_t kLineMask = kKeptStep - 1;

/// Where the steps of a ray lie in a list of lines.
struct LineSpan {
  uint64_t first;
  uint64_t count;
};

/// The steps of one ray still to do: the lines that its node visits read, marked as above, one a step with
/// FetchRule::kTexel. Empty from the start: the ray was dead at set-up.
struct RaySteps {
  const uint32_t* next;
  const uint32_t* end;
};

/// Writes down the lines of memory that rays read, each ray's in the order of its steps.
struct LineRecorder {
  const TexelLayout* layout;     ///< where texels lie; nullptr for a search, whose map has its own offsets
  int line_shift;                ///< log2 of the bytes of a line
  std::vector<uint32_t>* lines;  ///< appended to, ray after ray, in any order of rays
  LineSpan* spans;               ///< of each ray of the call

  uint32_t line_of(int level, int i, int j) const {
    return static_cast<uint32_t>(layout->offset(level, i, j) >> line_shift);
  }
};

/// Appends lines of one step, each once, in the order in which they come; `end_step` marks all but the last.
class StepLines {
 public:
  explicit StepLines(std::vector<uint32_t>& lines) : lines_(lines), first_(lines.size()) {}
  void add(uint32_t line) {
    if (std::find(lines_.begin() + static_cast<ptrdiff_t>(first_), lines_.end(), line) == lines_.end()) {
      lines_.push_back(line);
    }
  }
  void end_step() {
    for (size_t k = first_; k + 1 < lines_.size(); ++k) lines_[k] |= kMoreLines;
  }

 private:
  std::vector<uint32_t>& lines_;
  size_t first_;
};

/// Appends the different lines of a quad, row by row; all but the last carry kMoreLines.
inline void append_lines(const LineRecorder& recorder, const Quad& quad) {
  StepLines step(*recorder.lines);
  for (int j = quad.j; j < quad.j + quad.height; ++j) {
    for (int i = quad.i; i < quad.i + quad.width; ++i) step.add(recorder.line_of(quad.level, i, j));
  }
  step.end_step();
}

}  // namespace cuesta
