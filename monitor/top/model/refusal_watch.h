// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "monitor/ingest/intake.h"

namespace galilean::monitor::top {

/// Something that is not taken in from DDS, or was lost on the way, and goes on.
struct OngoingRefusal {
  std::string key;       ///< the same as long as it is the same
  std::string sender;    ///< the name that stands first in the topic, which may be no robot's
  std::string words;     ///< one sentence without its full stop
  bool is_loss = false;  ///< it was lost on the way; else it is not taken
};

/// Tells from counts which refusals go on. web/src/model/intake.ts does the same for the page.
class RefusalWatch {
 public:
  /// It goes on where its count rose so lately.
  static constexpr Duration kGoesOn = std::chrono::seconds(30);

  /// Takes in the counts at `now`. Call it at least some times within kGoesOn.
  void look(const Intake& intake, Time now);
  [[nodiscard]] std::vector<OngoingRefusal> ongoing(Time now) const;

 private:
  struct Count {
    OngoingRefusal refusal;
    std::uint64_t count = 0;
    Time rose{};
  };
  void note(OngoingRefusal refusal, std::uint64_t count, Time now);

  std::map<std::string, Count> counts_;  ///< by key; as many as Refusals tells apart
};

}  // namespace galilean::monitor::top
