// SPDX-License-Identifier: BSD-3-Clause
// The map's service between its own thread, the threads that bring messages and those that ask.
#include "monitor/map/map_service.h"

#include <gtest/gtest.h>

#include "core/wire/reader.h"
#include "core/wire/topic_names.h"
#include "tests/free_domain.h"

namespace galilean::monitor {
namespace {

constexpr std::array<const char*, 3> kTeam{"callisto", "ganymede", "io"};

msg::RobotState state_of(const std::string& robot, double x_m = 0) {
  msg::RobotState state;
  state.robot = robot;
  state.x_m = x_m;
  return state;
}

/// What a robot at the origin sees of a can that lies one metre in front of it.
msg::Sightings can_ahead(const std::string& robot) {
  msg::Sightings frame;
  frame.robot = robot;
  frame.view_angle_rad = 1;
  msg::Sighting& can = frame.items.emplace_back();
  can.object_class = "trash";
  can.x_m = can.range_m = 1;
  can.variance_xx = can.variance_yy = 9e-4;
  can.left_px = can.top_px = can.right_px = can.bottom_px = 100;
  return frame;
}

bool is_patient(std::chrono::steady_clock::time_point since) {
  return std::chrono::steady_clock::now() < since + std::chrono::seconds(20);
}

/// A message as Ingest hands it on. It keeps its channel.
class Arrival {
 public:
  Arrival(const wire::Schema* schema, Payload cdr)
      : channel_{1, "rt/test", schema}, cdr_(std::move(cdr)) {}
  [[nodiscard]] Message message() const { return {channel_, 0, 0, cdr_}; }

 private:
  Channel channel_;
  Payload cdr_;
};

class MapServiceTest : public testing::Test {
 protected:
  MapServiceTest() {
    for (const char* robot : kTeam) options.starts[robot] = {};
  }

  /// Returns a message in the bytes that DDS makes of it.
  template <class M>
  Arrival arrival_of(const M& message) {
    const std::string topic = wire::robot_topic("test_" + std::to_string(++topics), "bytes");
    wire::Writer<M> writer(*participant, topic);
    wire::Reader reader(*participant, topic, M::kRosType);
    Payload bytes;
    for (const auto began = std::chrono::steady_clock::now(); !bytes && is_patient(began);) {
      EXPECT_TRUE(writer.write(message));
      reader.take([&](const wire::Received& received) {
        bytes = std::make_shared<Payload::element_type>(received.cdr.begin(), received.cdr.end());
      });
    }
    return {wire::find_schema_by_ros_type(M::kRosType), bytes};
  }
  /// Waits until what was published last is as `is_it` wants it. Returns whether it came to that.
  template <class IsIt>
  static bool comes(const MapService& service, IsIt is_it) {
    const auto began = std::chrono::steady_clock::now();
    while (is_patient(began)) {
      if (const auto newest = service.newest(); newest && is_it(*newest)) return true;
      std::this_thread::yield();
    }
    return false;
  }

  static inline const int kDomain = free_domain();
  std::unique_ptr<wire::Participant> participant =
      wire::Participant::join(wire::kMonitorName, kDomain).value();
  SteadyClock clock;
  MapService::Options options;
  int topics = 0;
};

TEST_F(MapServiceTest, ThereIsNothingNewBeforeARobotIsHeard) {
  const Arrival state = arrival_of(state_of("io"));
  MapService service(*participant, clock, options);
  EXPECT_FALSE(service.newest());
  service.receive(state.message());
  EXPECT_TRUE(comes(service, [](const MapService::Newest& newest) {
    return newest.objects.robots.size() == 1 && newest.objects.robots[0].name == "io";
  }));
}

TEST_F(MapServiceTest, PublishesTheObjectsThatItKeeps) {
  const Arrival frame = arrival_of(can_ahead("io"));
  const Arrival state = arrival_of(state_of("io"));
  wire::Reader reader(*participant, wire::kObjectsTopic, msg::ObjectMap::kRosType);
  MapService service(*participant, clock, options);
  msg::ObjectMap published;
  for (const auto began = std::chrono::steady_clock::now();
       published.objects.empty() && is_patient(began);) {
    service.receive(state.message());
    service.receive(frame.message());
    reader.take([&](const wire::Received& received) {
      EXPECT_TRUE(msg::decode_cdr(received.cdr, published));
    });
    std::this_thread::yield();
  }
  ASSERT_EQ(published.objects.size(), 1U);
  EXPECT_EQ(published.objects[0].object_class, "trash");
  EXPECT_NEAR(published.objects[0].x_m, 1, 0.1);
  EXPECT_TRUE(comes(service, [](const MapService::Newest& newest) {
    return newest.objects.objects.size() == 1;
  }));
}

TEST_F(MapServiceTest, IgnoresAMessageThatDoesNotConcernTheMap) {
  const Arrival command = arrival_of(msg::Command{});
  const Arrival state = arrival_of(state_of("io"));
  MapService service(*participant, clock, options);
  service.receive(command.message());
  service.receive(state.message());
  EXPECT_TRUE(comes(
      service, [](const MapService::Newest& newest) { return newest.objects.robots.size() == 1; }));
}

TEST_F(MapServiceTest, CountsWhatItDropsAndGoesOn) {
  constexpr int kAtOnce = 20'000;
  const Arrival state = arrival_of(state_of("io"));
  MapService service(*participant, clock, options);
  for (const auto began = std::chrono::steady_clock::now();
       service.watch().dropped() == 0 && is_patient(began);)
    for (int i = 0; i < kAtOnce; ++i) service.receive(state.message());
  EXPECT_GT(service.watch().dropped(), 0U);
  EXPECT_NE(service.watch().problem(), "");
  EXPECT_EQ(service.watch().failures(), 0U);
  EXPECT_TRUE(comes(
      service, [](const MapService::Newest& newest) { return newest.objects.robots.size() == 1; }));
}

TEST_F(MapServiceTest, ThreadsMayBringMessagesAndAskAtTheSameTime) {
  constexpr int kMessages = 500;
  std::vector<Arrival> states;
  for (const char* robot : kTeam) states.push_back(arrival_of(state_of(robot, 0.5)));
  MapService service(*participant, clock, options);
  std::vector<std::thread> threads;
  for (const Arrival& state : states)
    threads.emplace_back([&] {
      for (int i = 0; i < kMessages; ++i) service.receive(state.message());
    });
  std::atomic<bool> ending = false;
  std::thread asks([&] {
    while (!ending) {
      (void)service.newest();
      EXPECT_GE(service.update_s(), 0);
      std::this_thread::yield();
    }
  });
  for (auto& thread : threads) thread.join();
  msg::ObjectMap first;
  EXPECT_TRUE(comes(service, [&](const MapService::Newest& newest) {
    first = newest.objects;
    return first.robots.size() == kTeam.size();
  }));
  EXPECT_TRUE(comes(service, [&](const MapService::Newest& newest) {
    return newest.objects.stamp.sec != first.stamp.sec ||
           newest.objects.stamp.nanosec != first.stamp.nanosec;
  })) << "it is asked while it publishes again";
  ending = true;
  asks.join();
}

}  // namespace
}  // namespace galilean::monitor
