#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "models/common/error.h"

namespace cuesta {

class Options;

/// What every verb gets from the command line around it.
struct Session {
  bool quiet = false;        ///< -q: no progress, no remarks; errors and asked-for output only
  std::string command_line;  ///< as typed, for manifests
};

/// One verb. A new one: a class in a file of its own, its maker in verbs.h and a row in the table of verbs.cpp.
class Command {
 public:
  virtual ~Command() = default;
  /// Adds the verb's arguments and options; name, sentence, example, --help and -q are already there.
  virtual void declare(Options& options) = 0;
  /// Does the work. Output that was asked for goes to stdout, remarks and progress to stderr. Throws
  /// cuesta::Error for bad input; the caller prints its sentence and ends the program with its code.
  virtual ExitCode run(const Session& session) = 0;
};

/// A row of the table of verbs.
struct Verb {
  std::string_view name;      ///< "run"; "heightmap make" is a verb of the group "heightmap"
  std::string_view sentence;  ///< what it does
  std::string_view example;   ///< a whole command line, with its output's name where it has one
  std::unique_ptr<Command> (*make)();
};

template <class C>
std::unique_ptr<Command> make_command() {
  return std::make_unique<C>();
}

}  // namespace cuesta
