// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <memory>
#include <set>
#include <string>
#include <thread>

#include "robot/devices/frame_grabber.h"
#include "robot/devices/shared_frame_ring.h"

namespace galilean::robot {
namespace {

using std::chrono::milliseconds;

/// A picture of one value throughout: a torn one shows two.
void write_plain(FrameRingWriter& writer, int value) {
  static thread_local std::array<std::uint8_t, Frame::kBytes> rgb;
  rgb.fill(static_cast<std::uint8_t>(value));
  writer.write(rgb);
}

bool is_plain(const Frame& frame) {
  return std::ranges::all_of(frame.rgb, [&](auto value) { return value == frame.rgb[0]; });
}

class FrameRing : public testing::Test {
 protected:
  ~FrameRing() override { SharedMemory::remove(name); }
  std::unique_ptr<FrameRingWriter> make_writer() {
    auto writer = FrameRingWriter::create(name);
    EXPECT_TRUE(writer.ok());
    return std::move(writer).value();
  }
  bool grab() {
    now += milliseconds(1100);
    return reader.grab(*frame, now) || reader.grab(*frame, now);
  }

  const std::string name = "/galilean-test-" + std::to_string(getpid());
  FrameRingReader reader{name};
  std::unique_ptr<Frame> frame = std::make_unique<Frame>();
  Time now{};
};

TEST_F(FrameRing, GivesTheNewestPictureOnce) {
  auto writer = make_writer();
  write_plain(*writer, 1);
  write_plain(*writer, 2);
  ASSERT_TRUE(grab());
  EXPECT_EQ(frame->rgb[0], 2);
  EXPECT_EQ(reader.problem(), "");
  EXPECT_FALSE(reader.grab(*frame, now));
  write_plain(*writer, 3);
  EXPECT_TRUE(reader.grab(*frame, now));
  EXPECT_EQ(frame->rgb[Frame::kBytes - 1], 3);
}

TEST_F(FrameRing, ReaderMayStartFirst) {
  EXPECT_FALSE(grab());
  EXPECT_NE(reader.problem().find(name), std::string::npos) << reader.problem();
  auto writer = make_writer();
  write_plain(*writer, 7);
  EXPECT_TRUE(grab());
  EXPECT_EQ(reader.problem(), "");
}

TEST_F(FrameRing, AWriterThatEndsIsToldAndItsSuccessorIsFound) {
  auto writer = make_writer();
  write_plain(*writer, 1);
  ASSERT_TRUE(grab());
  writer.reset();
  EXPECT_FALSE(grab());
  EXPECT_NE(reader.problem(), "");
  writer = make_writer();
  write_plain(*writer, 2);
  ASSERT_TRUE(grab());
  EXPECT_EQ(frame->rgb[0], 2);
}

TEST_F(FrameRing, AKilledWriterIsToldAndItsSuccessorTakesOver) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    auto writer = FrameRingWriter::create(name);
    write_plain(*writer.value(), 1);
    (void)!write(ready[1], "x", 1);
    pause();
    _exit(0);
  }
  char byte;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  ASSERT_TRUE(grab());
  EXPECT_FALSE(FrameRingWriter::create(name).ok()) << "two writers at once";
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_FALSE(grab());
  EXPECT_NE(reader.problem(), "");
  auto writer = make_writer();
  write_plain(*writer, 2);
  ASSERT_TRUE(grab());
  EXPECT_EQ(frame->rgb[0], 2);
  EXPECT_EQ(reader.problem(), "");
}

TEST_F(FrameRing, MemoryOfAnotherLayoutIsRefusedByReadersAndReplacedByWriters) {
  {
    auto other = SharedMemory::own(name, 4096);
    ASSERT_TRUE(other.ok());
    EXPECT_FALSE(grab());
    EXPECT_NE(reader.problem().find("layout"), std::string::npos) << reader.problem();
  }
  auto writer = make_writer();
  write_plain(*writer, 5);
  EXPECT_TRUE(grab());
}

TEST_F(FrameRing, PicturesAreNeverTorn) {
  auto writer = make_writer();
  write_plain(*writer, 0);
  ASSERT_TRUE(grab());
  std::atomic<bool> stop{false};
  std::jthread writing([&] {
    for (int i = 1; !stop; ++i) write_plain(*writer, i);
  });
  std::set<int> seen;
  for (int taken = 0; taken < 300;) {
    if (!reader.grab(*frame, now)) continue;
    ++taken;
    seen.insert(frame->rgb[0]);
    ASSERT_TRUE(is_plain(*frame));
  }
  stop = true;
  EXPECT_GT(seen.size(), 10u);
}

TEST_F(FrameRing, FrameGrabberTellsALostCameraAndComesBack) {
  auto grabber = std::make_unique<CameraGrabber>(reader, FrameGrabberSettings{});
  const auto step = [&](int ms) {
    now += milliseconds(ms);
    grabber->pump(now);
    grabber->pump(now);
    grabber->sense(now);
  };
  step(1);
  EXPECT_FALSE(grabber->healthy());
  EXPECT_EQ(grabber->frame().number, 0u);
  EXPECT_NE(grabber->problem(), "");
  auto writer = make_writer();
  write_plain(*writer, 9);
  step(1100);
  EXPECT_TRUE(grabber->healthy());
  EXPECT_EQ(grabber->frame().number, 1u);
  EXPECT_EQ(grabber->frame().rgb[5], 9);
  EXPECT_EQ(grabber->problem(), "");
  writer.reset();
  step(1100);
  EXPECT_FALSE(grabber->healthy());
  EXPECT_EQ(grabber->frame().rgb[5], 9);
  EXPECT_NE(grabber->problem(), "");
  writer = make_writer();
  write_plain(*writer, 10);
  step(1100);
  EXPECT_TRUE(grabber->healthy());
  EXPECT_EQ(grabber->frame().number, 2u);
}

}  // namespace
}  // namespace galilean::robot
