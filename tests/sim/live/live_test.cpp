// SPDX-License-Identifier: BSD-3-Clause
#include "sim/live/live.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "robot/devices/microcontroller_link.h"
#include "robot/devices/motor_drive.h"
#include "robot/devices/serial_port.h"
#include "tests/free_domain.h"

namespace galilean::sim {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
const int kDomain = free_domain();
constexpr auto kTick = 5ms;  // the simulator runs in real time here, and so do its robots

std::string own_run(const std::string& name) {
  return name + "-" + std::to_string(getpid());
}

/// A live simulator in a thread of its own.
class Simulator {
 public:
  explicit Simulator(const LiveOptions& options)
      : contest_(made(options)), thread_([this] { contest_->run(ending_); }) {}
  ~Simulator() {
    ending_ = true;
    thread_.join();
  }
  [[nodiscard]] nlohmann::json ready() const {
    return nlohmann::json::parse(contest_->ready_line());
  }

 private:
  static std::unique_ptr<LiveContest> made(const LiveOptions& options) {
    auto contest = LiveContest::make(load_scenario("practice").value(), options);
    if (!contest) throw std::runtime_error(contest.error().message);
    return std::move(contest).value();
  }

  std::atomic<bool> ending_{false};
  std::unique_ptr<LiveContest> contest_;
  std::thread thread_;
};

/// A robot's devices, as its process would open them.
struct Robot {
  explicit Robot(const nlohmann::json& devices)
      : port(devices["serial"], 115200),
        link(port, {}),
        drive(link, {}),
        camera(devices["camera"].get<std::string>().substr(std::string("ring:").size())) {}

  /// Pumps until `is_so`, for ten seconds at most.
  bool wait_until(const std::function<bool()>& is_so) {
    for (int i = 0; i < 2000; ++i) {
      link.pump(clock.now());
      link.sense(clock.now());
      frames += camera.grab(*frame, clock.now());
      if (is_so()) return true;
      std::this_thread::sleep_for(kTick);
    }
    return false;
  }

  SteadyClock clock;
  robot::SerialPort port;
  robot::MicrocontrollerLink link;
  robot::WheelDrive drive;
  robot::FrameRingReader camera;
  std::unique_ptr<Frame> frame = std::make_unique<Frame>();
  int frames = 0;
};

TEST(Live, ARobotConnectsSeesIsStartedAndComesBackAfterItsDeath) {
  const Simulator simulator(
      {.robots = 1, .run = own_run("alive"), .autostart_s = 0.3, .domain = kDomain});
  const auto devices = simulator.ready()["robots"][0];
  {
    Robot robot(devices);
    EXPECT_TRUE(robot.wait_until([&] { return robot.link.healthy(); })) << robot.link.problem();
    EXPECT_TRUE(robot.wait_until([&] { return robot.link.status().bumpers == 1; }));
    EXPECT_TRUE(robot.wait_until([&] { return robot.frames >= 3; }));
  }
  Robot reborn(devices);
  EXPECT_TRUE(reborn.wait_until([&] { return reborn.link.healthy(); })) << reborn.link.problem();
  EXPECT_TRUE(reborn.wait_until([&] { return reborn.frames >= 1; }));
}

TEST(Live, UnpluggedDevicesComeBack) {
  const Simulator simulator(
      {.robots = 1,
       .run = own_run("faulty"),
       .domain = kDomain,
       .faults = {{FaultyDevice::kSerial, "io", 1, 3}, {FaultyDevice::kCamera, "io", 1, 3}}});
  Robot robot(simulator.ready()["robots"][0]);
  ASSERT_TRUE(robot.wait_until([&] { return robot.link.healthy(); }));
  EXPECT_TRUE(robot.wait_until([&] { return !robot.link.healthy(); }));
  EXPECT_TRUE(robot.wait_until([&] { return !robot.camera.problem().empty(); }));
  EXPECT_TRUE(robot.wait_until([&] { return robot.link.healthy(); })) << robot.link.problem();
  robot.frames = 0;
  EXPECT_TRUE(robot.wait_until([&] { return robot.frames >= 3; })) << robot.camera.problem();
}

TEST(Live, NothingStaysBehindAndARunIsNotSimulatedTwice) {
  const std::string run = own_run("tidy");
  std::string folder;
  {
    const Simulator simulator({.robots = 2, .run = run, .domain = kDomain});
    folder = simulator.ready()["folder"];
    EXPECT_TRUE(fs::exists(folder + "/ganymede.serial"));
    EXPECT_TRUE(fs::exists("/dev/shm/galilean-" + run + "-io"));
    const auto second = LiveContest::make(load_scenario("practice").value(),
                                          {.robots = 1, .run = run, .domain = kDomain});
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find(run), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(folder));
  EXPECT_FALSE(fs::exists("/dev/shm/galilean-" + run + "-io"));
}

}  // namespace
}  // namespace galilean::sim
