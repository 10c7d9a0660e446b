// SPDX-License-Identifier: BSD-3-Clause
#include "sim/live/live_robot.h"

#include <array>
#include <utility>

namespace galilean::sim {

LiveRobot::LiveRobot(World& world, std::size_t index, const std::string& folder, std::string ring,
                     BootMemory memory)
    : name_(robot_name(index)),
      index_(index),
      body_(world.robot(index)),
      ring_name_(std::move(ring)),
      line_(folder + "/" + name_ + ".serial"),
      board_(world.robot(index), line_, name_, std::move(memory)) {}

Result<void> LiveRobot::plug_in() {
  if (auto line = line_.plug_in(); !line) return line;
  return open_ring();
}

Result<void> LiveRobot::open_ring() {
  if (ring_) return {};
  auto ring = robot::FrameRingWriter::create(ring_name_);
  if (!ring) return ring.error();
  ring_ = std::move(ring).value();
  return {};
}

Result<void> LiveRobot::apply_faults(const std::vector<DeviceFault>& faults, double now_s) {
  const BrokenParts& broken = body_.broken();
  board_.set_power(!broken.board);
  if (broken.serial_line || is_faulty(faults, FaultyDevice::kSerial, name_, now_s))
    line_.unplug();
  else if (auto line = line_.plug_in(); !line)
    return line;
  if (!broken.camera && !is_faulty(faults, FaultyDevice::kCamera, name_, now_s)) return open_ring();
  ring_.reset();
  return {};
}

void LiveRobot::ignore_commands() {
  std::array<std::uint8_t, 512> bytes;
  while (line_.read(bytes) > 0) {
  }
}

void LiveRobot::take_picture(const Scene& scene, Renderer& renderer) {
  if (!ring_) return;
  renderer.draw(scene, index_, *frame_);
  ring_->write(frame_->rgb);
}

}  // namespace galilean::sim
