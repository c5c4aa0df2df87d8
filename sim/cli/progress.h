#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "sim/cli/command.h"
#include "sim/session/progress.h"

namespace cuesta {

/// A bar with rate and time left on a terminal (stderr), plain lines every few seconds elsewhere, nothing when
/// quiet. Cheap to call often.
class ProgressBar {
 public:
  /// `unit` in the plural: "rays", "comparisons". `all` 0: the total is not known.
  ProgressBar(const Session& session, std::string label, std::string unit, uint64_t all);
  /// Clears the bar.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// False when the user asked to stop (Ctrl-C): keep what is finished and return ExitCode::kIncomplete.
  bool update(uint64_t finished);

 private:
  using Clock = std::chrono::steady_clock;
  void print(uint64_t finished, Clock::time_point now);

  bool quiet_;
  bool terminal_;
  bool drawn_ = false;
  std::string label_;
  std::string unit_;
  uint64_t all_;
  Clock::time_point start_;
  Clock::time_point next_;
};

/// A bar over rays as the functions of traces/ ask for it; it goes with the function's last copy.
std::function<bool(uint64_t finished)> watched(const Session& session, const std::string& label,
                                               uint64_t all);

/// Shows the stages of work as bars and its remarks as lines, all on stderr; nothing when quiet. Ctrl-C ends the work.
class TerminalObserver : public Observer {
 public:
  /// `session` must outlive it.
  explicit TerminalObserver(const Session& session) : session_(session) {}

  void on_begin(const std::string& label, const std::string& unit, uint64_t all) override;
  void on_progress(uint64_t finished) override;
  void on_end() override;
  void on_remark(const std::string& sentence) override;
  bool wants_stop() override;

 private:
  const Session& session_;
  std::optional<ProgressBar> bar_;
};

/// True once SIGINT, SIGTERM or SIGHUP has come; main() installs the handler, but leaves a signal alone that the
/// parent asked to ignore (nohup). A second signal ends the program at once.
bool stop_requested();
void install_stop_handler();

}  // namespace cuesta
