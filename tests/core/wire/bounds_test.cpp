// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/bounds.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

#include "core/wire/decode_untrusted.h"
#include "core/wire/messages.h"
#include "core/wire/schemas.h"
#include "tests/core/wire/cdr_bytes.h"

namespace galilean::wire {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Frame {
  std::string robot = "io";
  std::uint32_t nanosec = 0;
  double x_m = 1;
  float view_angle_rad = 1.2F;
  std::uint32_t items = 0;
};

/// Returns a Sightings without the items that it says it has.
std::vector<std::uint8_t> bytes_of(const Frame& frame) {
  return msg::CdrBytes()
      .stamp(7, frame.nanosec)
      .put(std::string_view(frame.robot))
      .put(frame.x_m)
      .put(2.0)
      .put(0.5)
      .put(frame.view_angle_rad)
      .put(frame.items)
      .bytes();
}

std::string fault(const Frame& frame) {
  return std::string(fault_of(bounds_of(msg::Sightings::kRosType), bytes_of(frame)));
}

TEST(Bounds, EveryMessageHasThem) {
  for (const auto& schema : schemas())
    EXPECT_NE(bounds_of(schema.ros_type), nullptr) << schema.ros_type;
  EXPECT_EQ(bounds_of("galilean_msgs/msg/Nothing"), nullptr);
}

TEST(Bounds, AreKeptByAMessageThatIsWell) {
  EXPECT_EQ(fault({}), "");
  msg::Sightings decoded;
  ASSERT_TRUE(msg::decode_cdr(bytes_of({}), decoded));
  EXPECT_EQ(decoded.view_angle_rad, 1.2F);
}

TEST(Bounds, HoldForWhatDidNotComeThroughAReader) {
  msg::Sightings decoded;
  EXPECT_TRUE(decode_untrusted(bytes_of({}), decoded));
  EXPECT_EQ(decoded.x_m, 1);
  EXPECT_FALSE(decode_untrusted(bytes_of({.x_m = kNan}), decoded));
  EXPECT_FALSE(decode_untrusted(bytes_of({.items = 1}), decoded)) << "it is cut short";
}

TEST(Bounds, RefuseNumbersThatNoRobotHas) {
  for (const float angle_rad : {static_cast<float>(kInfinity), -static_cast<float>(kInfinity),
                                static_cast<float>(kNan), -0.1F, 7.0F, 3e38F})
    EXPECT_EQ(fault({.view_angle_rad = angle_rad}), "Sightings.view_angle_rad is not from 0 to 6.3")
        << angle_rad;
  for (const double x_m : {kInfinity, -kInfinity, kNan, 1e308, -1e7})
    EXPECT_EQ(fault({.x_m = x_m}), "Sightings.x_m is not from -1e6 to 1e6") << x_m;
  EXPECT_EQ(fault({.x_m = std::numeric_limits<double>::denorm_min()}), "");
}

TEST(Bounds, RefuseNamesThatNoRobotHas) {
  for (const auto& name : {std::string(), std::string("7of9"), std::string("io europa"),
                           std::string("io/state"), std::string("\xff"), std::string(65, 'a')})
    EXPECT_EQ(fault({.robot = name}), "Sightings.robot is not a valid name of a robot") << name;
  EXPECT_EQ(fault({.robot = std::string(64, 'a')}), "");
}

TEST(Bounds, RefuseStampsThatAreNoTime) {
  EXPECT_EQ(fault({.nanosec = 1'000'000'000}), "Time.nanosec is not from 0 to 999999999");
}

TEST(Bounds, RefuseMoreEntriesThanThereMayBeBeforeTheyAreRead) {
  EXPECT_EQ(fault({.items = 0xffffffff}), "Sightings.items has more than 256 entries");
  EXPECT_EQ(fault({.items = 3}), "it is cut short, or is not in plain CDR");
}

TEST(Bounds, AreSaidToBeBrokenWhereTheMessageIsCutShort) {
  const auto whole = bytes_of({});
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_EQ(fault_of(bounds_of(msg::Sightings::kRosType), std::span(whole).first(size)),
              "it is cut short, or is not in plain CDR")
        << size;
}

TEST(Bounds, TellTheRobotThatAMessageIsOf) {
  const auto bytes = bytes_of({.robot = "europa"});
  msg::CdrChecker checker(bytes);
  bounds_of(msg::Sightings::kRosType)(checker);
  EXPECT_EQ(checker.robot(), "europa");
}

TEST(Bounds, LeaveNumbersAloneThatARobotAnswersTo) {
  const auto push = msg::CdrBytes()
                        .stamp()
                        .put(std::string_view("id"))
                        .put(std::string_view("operator"))
                        .put(std::uint32_t{0})  // targets
                        .put(std::string_view(""))
                        .put(std::string_view("hash"))
                        .put(std::uint32_t{0})  // files
                        .put(std::numeric_limits<float>::quiet_NaN())
                        .put(std::uint32_t{0})
                        .bytes();
  EXPECT_EQ(fault_of(bounds_of(msg::ProgramPush::kRosType), push), "");
}

/// Whoever walks through a message must agree with whoever decodes it on where each field stands.
TEST(Bounds, AreSaidToBeKeptOnlyWhereTheMessageCanBeDecoded) {
  std::mt19937 random(7);
  std::size_t kept = 0;
  for (int i = 0; i < 20'000; ++i) {
    auto bytes = bytes_of({.items = static_cast<std::uint32_t>(random() % 3)});
    bytes.resize(bytes.size() + random() % 200);
    for (unsigned changes = random() % 4; changes > 0; --changes)
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    msg::Sightings decoded;
    const bool is_whole = msg::decode_cdr(bytes, decoded);
    const bool is_kept = fault_of(bounds_of(msg::Sightings::kRosType), bytes).empty();
    EXPECT_TRUE(is_whole || !is_kept);
    if (is_kept) {
      ++kept;
      EXPECT_TRUE(decoded.view_angle_rad >= 0 && decoded.view_angle_rad <= 6.3F);
      EXPECT_LE(decoded.items.size(), 256U);
    }
  }
  EXPECT_GT(kept, 100U);
}

TEST(Bounds, StandEveryMessageOfAnyBytes) {
  std::mt19937 random(11);
  for (const auto& schema : schemas())
    for (int i = 0; i < 500; ++i) {
      std::vector<std::uint8_t> bytes(random() % 300);
      for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random() % 4 ? 0 : random());
      if (bytes.size() >= 2) {
        bytes[0] = 0;
        bytes[1] = 1;
      }
      static_cast<void>(fault_of(bounds_of(schema.ros_type), bytes));
    }
}

}  // namespace
}  // namespace galilean::wire
