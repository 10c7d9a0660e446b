// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/dashboard_feed.h"

#include <gtest/gtest.h>
#include <poll.h>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "tests/free_domain.h"

namespace galilean::monitor::top {
namespace {

/// Sends what one robot sees.
class Seer {
 public:
  Seer(wire::Participant& participant, std::string name)
      : name_(std::move(name)), writer_(participant, wire::robot_topic(name_, "sightings")) {}

  [[nodiscard]] bool is_read() const { return writer_.readers() > 0; }
  void see() {
    msg::Sightings seen;
    seen.robot = name_;
    seen.items.resize(1);
    EXPECT_TRUE(writer_.write(seen));
  }

 private:
  std::string name_;
  wire::Writer<msg::Sightings> writer_;
};

class WithSeers : public testing::Test {
 protected:
  /// Reads until `is_so`, or in vain for ten seconds.
  template <class Condition>
  bool until(const std::string& robot, Condition is_so) {
    for (int i = 0; i < 1000 && !is_so(); ++i) {
      pollfd event{feed.descriptor(), POLLIN, 0};
      ::poll(&event, 1, 10);
      feed.poll();
      feed.look_through(robot);
    }
    return is_so();
  }

  const int domain = free_domain();
  std::unique_ptr<wire::Participant> robots = wire::Participant::join("robots", domain).value();
  std::unique_ptr<wire::Participant> own = wire::Participant::join("top", domain).value();
  Seer io{*robots, "io"}, ganymede{*robots, "ganymede"};
  SteadyClock clock;
  DashboardFeed feed{*own, clock};
};

TEST_F(WithSeers, WithoutAMonitorReadsWhatTheShownRobotSeesAndNoOther) {
  ASSERT_TRUE(until("io", [&] { return io.is_read(); }));
  EXPECT_FALSE(ganymede.is_read());
  ASSERT_TRUE(until("io", [&] { return io.see(), feed.model().sightings("io") != nullptr; }));
  ASSERT_TRUE(until("ganymede", [&] { return ganymede.is_read() && !io.is_read(); }));
}

TEST_F(WithSeers, ReadsNoRobotsSightingsWhereAMonitorTellsOfTheMap) {
  ASSERT_TRUE(until("io", [&] { return io.is_read(); }));
  wire::Writer<msg::ObjectMap> map(*robots, wire::kObjectsTopic);
  ASSERT_TRUE(map.write({}));
  ASSERT_TRUE(until("io", [&] { return !io.is_read(); }));
  EXPECT_NE(feed.model().objects(), nullptr);
}

/// Tells a robot's variables.
class Teller {
 public:
  Teller(wire::Participant& participant, std::string name)
      : name_(std::move(name)), writer_(participant, wire::robot_topic(name_, "variables")) {}

  void tell(std::uint64_t tick) {
    msg::Variables variables;
    variables.robot = name_;
    variables.tick = tick;
    EXPECT_TRUE(writer_.write(variables));
  }

 private:
  std::string name_;
  wire::Writer<msg::Variables> writer_;
};

class WithTellers : public testing::Test {
 protected:
  /// Reads until the tick of the robot's variables that was taken last is this one, and lets so
  /// much time pass between two looks. Returns false after ten seconds in vain.
  bool until_taken(const std::string& robot, std::uint64_t tick, Duration each = {}) {
    for (int i = 0; i < 1000 && tick_of(robot) != tick; ++i) {
      pollfd event{feed.descriptor(), POLLIN, 0};
      ::poll(&event, 1, 10);
      clock.advance(each);
      feed.poll();
      feed.look_through("io");
    }
    return tick_of(robot) == tick;
  }
  std::uint64_t tick_of(const std::string& robot) const {
    const Robot* known = feed.model().team().find(robot);
    return known ? known->variables.tick : 0;
  }

  const int domain = free_domain();
  std::unique_ptr<wire::Participant> robots = wire::Participant::join("robots", domain).value();
  std::unique_ptr<wire::Participant> own = wire::Participant::join("top", domain).value();
  Teller io{*robots, "io"}, ganymede{*robots, "ganymede"};
  SteppedClock clock;
  DashboardFeed feed{*own, clock};
};

TEST_F(WithTellers, TheVariablesOfRobotsThatAreNotShownAreTakenTwiceASecond) {
  ganymede.tell(1);
  io.tell(1);
  ASSERT_TRUE(until_taken("io", 1));
  ASSERT_TRUE(until_taken("ganymede", 1, History::kEach));
  clock.advance(History::kEach);
  feed.poll();
  ganymede.tell(2);
  ganymede.tell(3);
  io.tell(2);
  ASSERT_TRUE(until_taken("io", 2));
  EXPECT_EQ(tick_of("ganymede"), 1U);
  EXPECT_TRUE(until_taken("ganymede", 3, History::kEach));
}

}  // namespace
}  // namespace galilean::monitor::top
