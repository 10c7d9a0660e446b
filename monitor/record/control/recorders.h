// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "core/clock.h"
#include "core/result.h"
#include "monitor/record/control/recorder_status.h"

namespace galilean::monitor {

/// The recorders that are heard in the domain, by their names.
class Recorders {
 public:
  /// A recorder that was not heard for longer than this is gone.
  static constexpr Duration kSilentAfter = std::chrono::seconds(3);

  void note(RecorderStatus status, Time now);
  /// Returns the newest status of the recorder of this name, or of the only one if `name` is empty.
  /// It is valid until the next call of `note`. Errors: it is not heard, or several are and `name`
  /// is empty; the error is a sentence that lists those that are.
  [[nodiscard]] Result<const RecorderStatus*> find(const std::string& name, Time now) const;

 private:
  struct Heard {
    RecorderStatus status;
    Time at;
  };
  std::map<std::string, Heard> heard_;
};

}  // namespace galilean::monitor
