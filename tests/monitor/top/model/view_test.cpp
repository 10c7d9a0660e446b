// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/view.h"

#include <gtest/gtest.h>

#include "core/wire/delivery.h"
#include "core/wire/messages.h"

namespace galilean::monitor::top {
namespace {

/// Plain CDR of what these tests tell, written by hand: the model takes bytes.
class Bytes {
 public:
  Bytes() : bytes_{0, 1, 0, 0} {}
  template <class T>
  Bytes& number(T value) {
    while ((bytes_.size() - 4) % sizeof(T)) bytes_.push_back(0);
    const auto* raw = reinterpret_cast<const std::uint8_t*>(&value);
    bytes_.insert(bytes_.end(), raw, raw + sizeof value);
    return *this;
  }
  Bytes& text(const std::string& value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    bytes_.insert(bytes_.end(), value.begin(), value.end());
    bytes_.push_back(0);
    return *this;
  }
  [[nodiscard]] Payload payload() const {
    return std::make_shared<const std::vector<std::uint8_t>>(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

class Told : public testing::Test {
 protected:
  void tell(const std::string& topic, std::string_view type, const Bytes& bytes) {
    const Channel channel{1, topic, wire::find_schema_by_ros_type(type), wire::Delivery::kState};
    model.receive({channel, 0, 0, bytes.payload()});
  }
  void tell_of_io() {
    tell("rt/io/variables", msg::Variables::kRosType,
         Bytes()
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .text("io")
             .number<std::uint64_t>(1)
             .number<std::uint32_t>(1)
             .text("trash")
             .number<std::uint8_t>(4)
             .text("")
             .number<std::uint8_t>(1)
             .number(0.5F)
             .number(0.1F)
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .number<std::uint32_t>(1)
             .number(1.0));
  }
  void tell_of_map(double x_m) {
    tell("rt/team/objects", msg::ObjectMap::kRosType,
         Bytes()
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .number<std::uint32_t>(1)
             .number<std::uint32_t>(7)
             .text("trash")
             .number(x_m)
             .number(2.0)
             .number(0.0)
             .number(0.0)
             .number(0.0)
             .number(0.9F)
             .number(0.1F)
             .number<std::int32_t>(0)
             .number<std::uint32_t>(0)
             .number<std::uint32_t>(0)
             .text("")
             .number<std::uint32_t>(0));
  }

  SteppedClock clock;
  DashboardModel model{clock};
};

TEST_F(Told, CertaintyDecaysBetweenMessages) {
  tell_of_io();
  ASSERT_EQ(make_view(model, clock, "io").variables.size(), 1u);
  EXPECT_NEAR(make_view(model, clock, "io").variables[0].certainty, 0.5, 1e-6);
  clock.advance(std::chrono::seconds(2));
  EXPECT_NEAR(make_view(model, clock, "io").variables[0].certainty, 0.3, 1e-6);
  clock.advance(std::chrono::seconds(9));
  EXPECT_EQ(make_view(model, clock, "io").variables[0].certainty, 0);
}

TEST_F(Told, WithoutAMonitorTheRobotsOwnFrameIsShown) {
  tell_of_io();
  EXPECT_EQ(make_view(model, clock, "").map_title, "io's own frame (no monitor)");
  tell_of_map(3);
  View view = make_view(model, clock, "");
  EXPECT_EQ(view.map_title, "the team's map");
  ASSERT_EQ(view.objects.size(), 1u);
  EXPECT_EQ(view.objects[0].position_m.x(), 3);
  clock.advance(std::chrono::seconds(6));
  view = make_view(model, clock, "");
  EXPECT_EQ(view.map_title, "io's own frame (no monitor)");
}

TEST_F(Told, BytesThatAreNoMessageChangeNothing) {
  tell_of_map(3);
  tell("rt/team/objects", msg::ObjectMap::kRosType, Bytes().number<std::uint32_t>(1));
  tell_of_io();
  EXPECT_EQ(make_view(model, clock, "").objects.size(), 1u);
}

}  // namespace
}  // namespace galilean::monitor::top
