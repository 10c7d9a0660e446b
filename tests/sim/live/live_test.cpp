// SPDX-License-Identifier: BSD-3-Clause
#include "sim/live/live.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "robot/devices/microcontroller_link.h"
#include "robot/devices/motor_drive.h"
#include "robot/devices/serial_port.h"
#include "tests/free_domain.h"
#include "tests/temporary_folder.h"

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

TEST(Live, ARobotThatOutlivesTheSimulatorKnowsThatItsBoardBeganAnew) {
  const TemporaryFolder boards;
  const LiveOptions options{
      .robots = 1, .run = own_run("outlived"), .domain = kDomain, .boards = boards.path()};
  std::optional<Simulator> simulator;
  simulator.emplace(options);
  Robot robot(simulator->ready()["robots"][0]);
  for (std::uint32_t epoch = 0; epoch < 3; ++epoch) {
    EXPECT_TRUE(robot.wait_until([&] { return robot.link.healthy(); })) << robot.link.problem();
    EXPECT_EQ(robot.link.status().epoch, epoch);
    simulator.reset();
    EXPECT_TRUE(robot.wait_until([&] { return !robot.link.healthy(); }));
    simulator.emplace(options);
  }
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

/// An instructor in a process of its own, as far as DDS can tell.
struct Teacher {
  /// Sends an order twice, and again until it is answered, for ten seconds at most.
  msg::SimulationEvent says(msg::SimulationOrder order) {
    order.id = std::to_string(++said);
    order.author = "teacher";
    msg::SimulationEvent answer;
    for (int i = 0; i < 1000 && answer.order_id != order.id; ++i) {
      const bool sent = i % 20 != 0 || (orders.write(order) && orders.write(order));
      EXPECT_TRUE(sent);
      std::this_thread::sleep_for(10ms);
      events.take([&](const wire::Received& received) {
        msg::SimulationEvent event;
        if (msg::decode_cdr(received.cdr, event) && event.order_id == order.id) answer = event;
      });
    }
    return answer;
  }

  std::unique_ptr<wire::Participant> member = wire::Participant::join("teacher", kDomain).value();
  wire::Writer<msg::SimulationOrder> orders{*member, wire::kSimulationOrderTopic};
  wire::Reader events{*member, wire::kSimulationEventTopic, msg::SimulationEvent::kRosType};
  int said = 0;
};

TEST(Live, AnInstructorPausesBreaksAndMends) {
  const std::string run = own_run("taught");
  const Simulator simulator({.robots = 1, .run = run, .domain = kDomain});
  Robot robot(simulator.ready()["robots"][0]);
  ASSERT_TRUE(robot.wait_until([&] { return robot.link.healthy(); }));
  Teacher teacher;
  msg::SimulationOrder order;
  order.simulation = run;
  order.order = "pause";
  const auto paused = teacher.says(order);
  EXPECT_TRUE(paused.done) << paused.text;
  EXPECT_EQ(paused.author, "teacher");
  EXPECT_TRUE(robot.wait_until([&] { return !robot.link.healthy(); }));
  order.order = "go_on";
  const auto went_on = teacher.says(order);
  EXPECT_TRUE(went_on.done);
  EXPECT_EQ(went_on.step, paused.step);
  EXPECT_EQ(went_on.number, paused.number + 1);
  EXPECT_TRUE(robot.wait_until([&] { return robot.link.healthy(); })) << robot.link.problem();
  order.order = "break";
  order.subject = "io";
  order.part = "camera";
  EXPECT_TRUE(teacher.says(order).done);
  EXPECT_TRUE(robot.wait_until([&] { return !robot.camera.problem().empty(); }));
  order.order = "mend";
  EXPECT_TRUE(teacher.says(order).done);
  robot.frames = 0;
  EXPECT_TRUE(robot.wait_until([&] { return robot.frames >= 3; })) << robot.camera.problem();
  EXPECT_FALSE(teacher.says(order).done);
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
