// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/clock.h"
#include "core/device/frame.h"
#include "core/result.h"
#include "robot/devices/frame_source.h"
#include "robot/devices/shared_memory.h"

namespace galilean::robot {

/// Passes pictures from one process to others through POSIX shared memory. Each slot is a seqlock,
/// so that a reader gets whole pictures only, and one word holds the newest number. A reader never
/// delays the writer. Either may end and come back at any moment. Names are like
/// "/galilean-<run>-io".
struct FrameRingLayout;

/// The writing side: the simulator's camera. Its destructor removes the name.
class FrameRingWriter {
 public:
  /// Takes over the memory that a killed writer left. Errors: another writer still uses it.
  [[nodiscard]] static Result<std::unique_ptr<FrameRingWriter>> create(const std::string& name);
  ~FrameRingWriter();
  FrameRingWriter(const FrameRingWriter&) = delete;
  FrameRingWriter& operator=(const FrameRingWriter&) = delete;

  void write(std::span<const std::uint8_t, Frame::kBytes> rgb);

 private:
  FrameRingWriter(std::string name, SharedMemory memory);
  [[nodiscard]] FrameRingLayout& ring();

  std::string name_;
  SharedMemory memory_;
};

/// The reading side: the robot's frame source.
class FrameRingReader final : public FrameSource {
 public:
  explicit FrameRingReader(std::string name);

  bool grab(Frame& frame, Time now) override;
  [[nodiscard]] std::string problem() const override;

 private:
  void look_for_ring(Time now);
  bool copy_newest(Frame& frame);

  std::string name_;
  std::optional<SharedMemory> memory_;
  std::string problem_;
  std::uint64_t generation_ = 0;
  std::uint64_t number_ = 0;
  Time last_picture_{};
  Time last_look_{};
  bool looked_ = false;
};

}  // namespace galilean::robot
