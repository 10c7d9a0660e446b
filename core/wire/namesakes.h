// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace galilean::wire {

class Participant;

/// Finds the other processes of the domain that joined under the name of this one and read certain
/// topics, of whatever release they are and whether or not anything can be heard of them. One
/// thread at a time may call it.
class Namesakes {
 public:
  /// A process that reads none of `topics` does not count: a tool may be called as a robot is.
  /// Requires: `participant` outlives this. Errors: throws std::runtime_error if Cyclone refuses.
  Namesakes(Participant& participant, std::vector<std::string> topics);
  ~Namesakes();
  Namesakes(const Namesakes&) = delete;
  Namesakes& operator=(const Namesakes&) = delete;

  /// Returns how many there are. One that died counts until DDS misses it, ten seconds later. Who
  /// joins after its death never hears of it. Errors: as the constructor.
  [[nodiscard]] int count();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace galilean::wire
