#pragma once

#include <cstdint>
#include <string>

namespace cuesta {

/// Hears how far work that takes long has come, and may end it: a terminal's bar, a notebook, a test. Every function
/// does nothing unless it is overridden, and is called by the thread that asked for the work.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Says that a stage begins: what it is called, what is counted of it (in the plural), and how many there are in
  /// all; 0: that is not known.
  virtual void on_begin(const std::string& label, const std::string& unit, uint64_t all) {
    static_cast<void>(label), static_cast<void>(unit), static_cast<void>(all);
  }
  /// Says how many of the stage's units are finished. Called often.
  virtual void on_progress(uint64_t finished) { static_cast<void>(finished); }
  /// Says that the stage is over, whole or not.
  virtual void on_end() {}
  /// Takes a sentence that is worth knowing and no result: what is about to run, what was left out.
  virtual void on_remark(const std::string& sentence) { static_cast<void>(sentence); }
  /// Says whether the work shall end now. Asked often; what is finished by then is kept.
  virtual bool wants_stop() { return false; }
};

/// A stage of work that an observer hears of: it begins with the object and ends with it.
class Stage {
 public:
  Stage(Observer& observer, const std::string& label, const std::string& unit, uint64_t all)
      : observer_(observer) {
    observer_.on_begin(label, unit, all);
  }
  ~Stage() { observer_.on_end(); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Passes the count on; false when the observer wants the work to end.
  bool update(uint64_t finished) {
    observer_.on_progress(finished);
    return !observer_.wants_stop();
  }

 private:
  Observer& observer_;
};

}  // namespace cuesta
