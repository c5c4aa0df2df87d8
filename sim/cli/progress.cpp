#include "sim/cli/progress.h"

#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <memory>

namespace cuesta {
namespace {

using namespace std::chrono_literals;

constexpr int kBarWidth = 30;

volatile std::sig_atomic_t g_stop = 0;

extern "C" void on_stop(int signal) {
  g_stop = 1;
  std::signal(signal, SIG_DFL);  // the second one ends the program
}

std::string short_time(double seconds) {
  const auto whole = std::lround(seconds);
  char text[32];
  if (whole < 3600) {
    std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
  }
  return text;
}

std::string short_rate(double per_second) {
  const char* const units[] = {"", " k", " M", " G"};
  int unit = 0;
  while (per_second >= 1000 && unit < 3) {
    per_second /= 1000;
    ++unit;
  }
  char text[32];
  std::snprintf(text, sizeof text, "%.3g%s", per_second, units[unit]);
  return text;
}

}  // namespace

std::function<bool(uint64_t)> watched(const Session& session, const std::string& label, uint64_t all) {
  auto bar = std::make_shared<ProgressBar>(session, label, "rays", all);
  return [bar](uint64_t finished) { return bar->update(finished); };
}

void TerminalObserver::on_begin(const std::string& label, const std::string& unit, uint64_t all) {
  bar_.emplace(session_, label, unit, all);
}

void TerminalObserver::on_progress(uint64_t finished) {
  if (bar_) bar_->update(finished);
}

void TerminalObserver::on_end() { bar_.reset(); }

void TerminalObserver::on_remark(const std::string& sentence) {
  if (!session_.quiet) std::fprintf(stderr, "%s\n", sentence.c_str());
}

bool TerminalObserver::wants_stop() { return stop_requested(); }

bool stop_requested() { return g_stop != 0; }

void install_stop_handler() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(signal, on_stop) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

ProgressBar::ProgressBar(const Session& session, std::string label, std::string unit, uint64_t all)
    : quiet_(session.quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      label_(std::move(label)),
      unit_(std::move(unit)),
      all_(all),
      start_(Clock::now()),
      next_(start_ + (terminal_ ? Clock::duration(200ms) : Clock::duration(5s))) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

bool ProgressBar::update(uint64_t finished) {
  if (!quiet_) {
    const auto now = Clock::now();
    if (now >= next_) {
      print(finished, now);
      next_ = now + (terminal_ ? Clock::duration(200ms) : Clock::duration(5s));
    }
  }
  return !stop_requested();
}

void ProgressBar::print(uint64_t finished, Clock::time_point now) {
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(finished) / seconds;
  std::string line = label_ + " ";
  if (all_ > 0) {
    const double share = static_cast<double>(finished) / static_cast<double>(all_);
    if (terminal_) {
      const int full = static_cast<int>(share * kBarWidth);
      line += "[" + std::string(static_cast<size_t>(full), '#') +
              std::string(static_cast<size_t>(kBarWidth - full), '.') + "] ";
    }
    line += std::to_string(static_cast<int>(share * 100)) + " % ";
  } else {
    line += std::to_string(finished) + " ";
  }
  line += short_rate(rate) + " " + unit_ + "/s";
  if (all_ > 0 && rate > 0) line += ", " + short_time(static_cast<double>(all_ - finished) / rate) + " left";
  std::fprintf(stderr, terminal_ ? "\r\033[K%s" : "%s\n", line.c_str());
  std::fflush(stderr);
  drawn_ = terminal_;
}

}  // namespace cuesta
