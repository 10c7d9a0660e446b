// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace galilean::wire {

class Participant;

/// A writer somewhere in the domain.
struct Publication {
  std::string topic;        ///< as on DDS: "rt/io/state"
  std::string dds_type;     ///< "galilean_msgs::msg::dds_::RobotState_"
  std::string writer;       ///< its GUID, hexadecimal
  std::string participant;  ///< the GUID of the process that it belongs to
  bool operator==(const Publication&) const = default;
};

/// Finds which topics are written in the domain by any process.
class Discovery {
 public:
  explicit Discovery(Participant& participant);
  ~Discovery();
  /// Returns the publications that are known now.
  [[nodiscard]] std::vector<Publication> publications() const;
  /// Publications that were not returned before.
  struct Fresh {
    std::vector<Publication> publications;
    bool are_more = false;  ///< others wait, or may wait: call `take_new` again
  };
  /// Returns at most `most` of the publications that are new since the last call; at the first call
  /// all are new. Its work is bounded, however many there are.
  [[nodiscard]] Fresh take_new(std::size_t most);
  /// Sets the callback that a thread of Cyclone calls whenever the publications change. Requires:
  /// it is set once, right after construction.
  void on_change(std::function<void()> callback);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace galilean::wire
