// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "core/clock.h"
#include "core/key_terminal.h"
#include "monitor/record/control/recorder_desk.h"
#include "monitor/record/recorder.h"

namespace galilean::monitor {

/// Lets people pause a recorder, let it go on and end it: by keys in its terminal, and by commands
/// over DDS. For use by one thread.
class Steering {
 public:
  struct Setup {
    Recorder& recorder;
    const RecordingFiles& files;
    RecorderDesk& desk;
    const Clock& clock;
    std::string host;                             ///< this machine's name
    std::function<void(const std::string&)> say;  ///< gets a sentence for each pause
  };

  /// Requires: what `setup` refers to outlives this.
  explicit Steering(Setup setup) : setup_(std::move(setup)) {}

  /// Returns what poll can wait for; a negative one, which it ignores, without a terminal.
  [[nodiscard]] int descriptor() const noexcept { return keys_.descriptor(); }
  /// Says which keys there are, if there is a terminal.
  void greet() const;
  /// Obeys what was asked for since the last call, and tells the domain how the recorder is.
  /// Errors: the file cannot be written.
  [[nodiscard]] Result<void> obey();
  /// Returns whether a key has ended the recording.
  [[nodiscard]] bool ended() const noexcept { return ended_; }

 private:
  [[nodiscard]] Result<void> obey_keys(const std::string& bytes);
  [[nodiscard]] Result<void> pause(const std::string& by);
  [[nodiscard]] Result<void> resume();
  void tell();

  Setup setup_;
  KeyTerminal keys_;
  std::string obeyed_;  ///< the id of the newest command
  Time next_tell_{};
  bool ended_ = false;
};

}  // namespace galilean::monitor
