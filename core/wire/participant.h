#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::wire {

/// An entity of Cyclone's, deleted with this object.
class Entity {
 public:
  Entity() = default;
  explicit Entity(std::int32_t handle) noexcept : handle_(handle) {}
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Entity();
  [[nodiscard]] std::int32_t handle() const noexcept { return handle_; }

 private:
  std::int32_t handle_ = 0;
};

/// What the monitor joins as, by which robots know it.
inline constexpr const char* kMonitorName = "monitor";

/// A process's membership in a DDS domain. Must go before `main` returns (Cyclone's threads outlive
/// exit handlers otherwise). Several on one machine find one another with or without multicast;
/// on other machines by multicast, or by the addresses in GALILEAN_PEERS (separated by commas).
/// CYCLONEDDS_URI, where set, has the last word.
class Participant {
 public:
  /// `name` is what others are shown. Domain: ROS_DOMAIN_ID where `domain` is negative, else 0.
  [[nodiscard]] static Result<std::unique_ptr<Participant>> join(const std::string& name,
                                                                 int domain = -1);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  [[nodiscard]] std::int32_t handle() const noexcept;
  /// The entity of one topic, made at first use. Throws std::runtime_error if Cyclone refuses it or
  /// if `ros_type` is not one of the messages.
  [[nodiscard]] std::int32_t topic(const std::string& name, const std::string& ros_type);

 private:
  struct State;
  explicit Participant(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// A writer somewhere in the domain.
struct Publication {
  std::string topic;        ///< as on DDS: "rt/io/state"
  std::string dds_type;     ///< "galilean_msgs::msg::dds_::RobotState_"
  std::string writer;       ///< its GUID, hexadecimal
  std::string participant;  ///< the GUID of the process that it belongs to
  bool operator==(const Publication&) const = default;
};

/// Sees which topics are written in the domain, by anybody.
class Discovery {
 public:
  explicit Discovery(Participant& participant);
  ~Discovery();
  /// All that are there now.
  [[nodiscard]] std::vector<Publication> publications() const;
  /// Called on a thread of Cyclone's whenever that changes. Set once, right after construction.
  void on_change(std::function<void()> callback);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace galilean::wire
