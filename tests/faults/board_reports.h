// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <iostream>
#include <sstream>
#include <vector>

#include "robot/firmware/messages.h"

namespace galilean::faults {

/// Returns the wall clock's time since the Unix epoch [ms].
inline double wall_ms() {
  using namespace std::chrono;
  return duration<double, std::milli>(system_clock::now().time_since_epoch()).count();
}

/// Tells what a board reports, and lets it seem to have been restarted.
class BoardReports {
 public:
  void restart() {
    ++boots_;
    silent_until_ = Stopwatch::now() + kBooting;
    is_first_ = true;
  }
  /// Returns what the robot is to hear instead of `bytes`.
  std::vector<std::uint8_t> heard(const std::vector<std::uint8_t>& bytes) {
    std::vector<std::uint8_t> frames;
    for (const auto byte : bytes)
      if (decoder_.push(byte)) add(decoder_.frame(), frames);
    if (Stopwatch::now() < silent_until_) return {};
    return boots_ > 0 ? frames : bytes;
  }

 private:
  void add(const robot::firmware::Frame& frame, std::vector<std::uint8_t>& frames) {
    std::array<std::uint8_t, robot::firmware::kMaxEncoded> encoded{};
    std::size_t size = 0;
    robot::firmware::Status status;
    robot::firmware::HelloReply reply;
    if (frame.type == static_cast<std::uint8_t>(robot::firmware::MessageType::kStatus) &&
        unpack(frame, status)) {
      tell(status);
      size = encode_message(since_boot(status), frame.sequence, encoded);
    } else if (frame.type == static_cast<std::uint8_t>(robot::firmware::MessageType::kHelloReply) &&
               unpack(frame, reply)) {
      reply.boot_count = static_cast<std::uint16_t>(reply.boot_count + boots_);
      reply.uptime_ms -= first_.uptime_ms;
      size = encode_message(reply, frame.sequence, encoded);
    } else {
      size = robot::firmware::encode(frame, encoded);
    }
    frames.insert(frames.end(), encoded.begin(),
                  encoded.begin() + static_cast<std::ptrdiff_t>(size));
  }
  robot::firmware::Status since_boot(robot::firmware::Status status) {
    if (is_first_ && boots_ > 0) first_ = status;
    is_first_ = false;
    status.boot_count = static_cast<std::uint16_t>(status.boot_count + boots_);
    status.uptime_ms -= first_.uptime_ms;
    status.left_encoder_counts -= first_.left_encoder_counts;
    status.right_encoder_counts -= first_.right_encoder_counts;
    return status;
  }
  static void tell(const robot::firmware::Status& status) {
    std::ostringstream line;
    line << std::fixed << "{\"at_ms\":" << wall_ms() << ",\"left\":" << status.left_speed_counts_s
         << ",\"right\":" << status.right_speed_counts_s << ",\"flags\":" << int{status.flags}
         << ",\"rejected\":" << status.rejected_frames << "}\n";
    std::cout << line.str() << std::flush;
  }

  using Stopwatch = std::chrono::steady_clock;
  static constexpr auto kBooting = std::chrono::milliseconds(300);

  robot::firmware::FrameDecoder decoder_;
  unsigned boots_ = 0;
  bool is_first_ = false;
  robot::firmware::Status first_;  ///< after the newest restart
  Stopwatch::time_point silent_until_{};
};

}  // namespace galilean::faults
