#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/wire/messages.h"
#include "core/wire/participant.h"

namespace galilean::wire {

/// How a kind of message travels; decided once, by its type, in qos.cpp.
enum class Delivery {
  kState,    ///< what is: reliable, transient-local, keep-last 1; a late joiner knows at once
  kEvent,    ///< what happens: reliable, transient-local, keep-last 64; numbered, so that receivers
             ///< drop repeats
  kCommand,  ///< reliable, volatile, keep-last 64
  kFlow,     ///< reliable, volatile, keep-last 10: what ROS 2 tools ask of odometry, tf and
             ///< diagnostics
  kStream    ///< best effort, volatile, keep-last 1
};
[[nodiscard]] Delivery delivery_of(std::string_view ros_type) noexcept;

/// "rt/io/state" for ("io", "state"): ROS 2's name for topic /io/state.
[[nodiscard]] std::string robot_topic(std::string_view robot, std::string_view leaf);
inline constexpr const char* kProgramPushTopic = "rt/team/program_push";
inline constexpr const char* kProgramRollbackTopic = "rt/team/program_rollback";
inline constexpr const char* kPushProgressTopic = "rt/team/push_progress";
inline constexpr const char* kCommandTopic = "rt/team/command";
inline constexpr const char* kObjectsTopic = "rt/team/objects";
inline constexpr const char* kMapTopic = "rt/team/map";
inline constexpr const char* kMarkersTopic = "rt/team/markers";
inline constexpr const char* kScoreTopic = "rt/referee/score";
inline constexpr const char* kTfTopic = "rt/tf";
inline constexpr const char* kDiagnosticsTopic = "rt/diagnostics";
inline constexpr const char* kLogTopic = "rt/rosout";

/// Nanoseconds since the Unix epoch, in the message form; and now, for stamps alone.
[[nodiscard]] msg::Time ros_time(std::int64_t since_epoch_ns) noexcept;
[[nodiscard]] std::int64_t since_epoch_ns(const msg::Time& time) noexcept;
[[nodiscard]] std::int64_t wall_clock_ns() noexcept;

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

/// One message as it came: valid during the callback only.
struct Received {
  std::span<const std::uint8_t> cdr;  ///< with its four-byte header
  std::int64_t sent_ns;               ///< by its writer's clock, since the Unix epoch
  std::uint64_t writer;               ///< for Reader::sender
};

/// Takes messages off one topic as bytes; msg::decode_cdr makes structs of them.
class Reader {
 public:
  /// `depth`: messages of each writer kept between two calls of `take`; 0: as the type's delivery
  /// says, which for a state is the newest alone.
  Reader(Participant& participant, const std::string& topic, const std::string& ros_type,
         int depth = 0);
  ~Reader();
  /// Calls `receive` for each message that came since, oldest first, in the calling thread.
  void take(const std::function<void(const Received&)>& receive);
  /// Called on a thread of Cyclone's when there is something to take. Set once.
  void on_data(std::function<void()> callback);
  /// Writers matched now.
  [[nodiscard]] int writers() const;
  /// The name that the process which wrote a message has joined the domain with. It is what that
  /// process announced to everybody, not a field of the message; DDS without its security does not
  /// prove it. Nothing if the writer has left.
  [[nodiscard]] std::optional<std::string> sender(const Received& received) const;

 private:
  Entity entity_;
  std::unique_ptr<std::function<void()>> callback_;
};

}  // namespace galilean::wire
