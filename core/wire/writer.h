// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/lingering_entity.h"

namespace galilean::wire {

class Participant;

/// Writes messages of one type to one topic. `write` may block for some milliseconds (more after a
/// partition): never call it from the control loop. The destructor may wait for readers, as
/// LingeringEntity tells.
template <class M>
class Writer {
 public:
  /// A topic that DDS Security does not permit to write is left out: `write` then takes nothing.
  Writer(Participant& participant, const std::string& topic);
  /// Returns false if Cyclone did not take the message in time. The message is then lost.
  [[nodiscard]] bool write(const M& message);
  /// Returns the number of readers that are matched now. A message that is costly to make need not
  /// be made when there is none.
  [[nodiscard]] int readers() const;

 private:
  LingeringEntity entity_;
};

}  // namespace galilean::wire
