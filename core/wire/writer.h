// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/entity.h"

namespace galilean::wire {

class Participant;

/// Writes messages of one type to one topic. `write` may block for some milliseconds (more after a
/// partition): never call it from the control loop.
template <class M>
class Writer {
 public:
  Writer(Participant& participant, const std::string& topic);
  /// False if Cyclone did not take it in time; the message is then lost.
  [[nodiscard]] bool write(const M& message);
  /// Readers matched now: what is costly to make is made only for somebody.
  [[nodiscard]] int readers() const;

 private:
  Entity entity_;
};

}  // namespace galilean::wire
