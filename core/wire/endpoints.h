// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/wire/participant.h"

namespace galilean::wire {

/// The parts of an endpoint's quality of service that decide whether a writer matches a reader.
struct EndpointQos {
  enum class Durability { kVolatile, kTransientLocal, kTransient, kPersistent };
  bool reliable = false;
  Durability durability = Durability::kVolatile;
  bool exclusive = false;
  std::int64_t deadline_ns = INT64_MAX;  ///< INT64_MAX: none
  int depth = 1;                         ///< messages kept; 0: all
  bool operator==(const EndpointQos&) const = default;
};

/// A writer or a reader somewhere in the domain.
struct EndpointInfo {
  bool writes = false;
  std::string topic;     ///< as on DDS: "rt/io/state"
  std::string dds_type;  ///< "galilean_msgs::msg::dds_::RobotState_"
  std::string process;   ///< the name with which its process joined, or its GUID
  EndpointQos qos;
  /// The hash by which XTypes names the definition of its type, in hexadecimal. It is empty if the
  /// endpoint publishes none, and for those of this process.
  std::string type_hash = {};
  bool keyed = false;        ///< whether its type has keys
  std::uint64_t handle = 0;  ///< Received::writer of what it writes; another one after a while in
                             ///< which it was not heard
  std::string guid = {};     ///< by which the whole domain knows it, hexadecimal
};

/// Finds all writers and readers of the domain, except those of DDS itself.
class Endpoints {
 public:
  explicit Endpoints(Participant& participant);
  ~Endpoints();
  /// Returns those that are known now, ordered by topic and process.
  [[nodiscard]] std::vector<EndpointInfo> known();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace galilean::wire
