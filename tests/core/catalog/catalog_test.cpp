// SPDX-License-Identifier: BSD-3-Clause
#include "core/catalog/catalog.h"

#include <gtest/gtest.h>

#include "core/catalog/registry.h"
#include "core/device/devices.h"
#include "tests/robot/fake_devices.h"

namespace galilean {
namespace {

/// A schema with an attribute of every sort.
class Example final : public MotorSchema {
 public:
  static void describe(Declaration<Example>& is) {
    is.help("For the test.");
    is.drives("motor_drive");
    is.needs("motor_drive");
    is.needs("comm_port");
    is.reads(&Example::goal_, "goal_variable", "what to read");
    is.writes(&Example::result_, "result", "what to write").optional();
    is.number(&Example::radius_m_, "radius", unit::kCentimetre, 20, "a length")
        .range(0, 100)
        .alias("raduis");
    is.pair(&Example::offset_m_, "offset", unit::kCentimetre, Vec2(0, 22), "a point");
    is.reads_all(&Example::inputs_, "inputs", "forces");
    is.numbers(&Example::gains_, "gains", unit::kNone, {}, "of the forces")
        .role(Role::kGain, "inputs");
    is.number(&Example::index_, "bit_index", unit::kNone, 0, "which").bit_of("bits_variable");
    is.choice(&Example::sum_, "mode", {"average", "sum"}, "average", "how");
  }
  void run(const Tick&) override {}

  const Variable<Locate>* goal_ = nullptr;
  Variable<Force>* result_ = nullptr;
  double radius_m_ = 0;
  Vec2 offset_m_ = Vec2::Zero();
  std::vector<const Variable<Force>*> inputs_;
  std::vector<double> gains_;
  int index_ = 0;
  bool sum_ = false;
};

TEST(Catalog, SurvivesJson) {
  Registry registry;
  registry.add_schema<Example>("example");
  const auto text = catalog_to_json(registry.catalog());
  const auto read = catalog_from_json(text);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(catalog_to_json(read.value()), text);
  EXPECT_EQ(read.value().find("example")->drives, "motor_drive");
  EXPECT_EQ(read.value().find("example")->needs,
            (std::vector<std::string>{"motor_drive", "comm_port"}));
  EXPECT_EQ(read.value().find("example")->find("bit_index")->bit_of, "bits_variable");
  const auto* radius = read.value().find("example")->find("raduis");
  ASSERT_NE(radius, nullptr);
  EXPECT_EQ(radius->name, "radius");
  EXPECT_EQ(radius->unit.symbol, "cm");
  EXPECT_EQ(radius->maximum, 100);
  EXPECT_FALSE(radius->required());
  EXPECT_TRUE(read.value().find("example")->find("goal_variable")->required());
}

/// Gets the devices and does not say which it needs.
class Careless final : public PerceptualSchema {
 public:
  static void describe(Declaration<Careless>& is) {
    is.help("For the test.");
    is.uses_devices(&Careless::devices_);
  }
  void run(const Tick&) override {}

 private:
  const Devices* devices_ = nullptr;
};

TEST(Catalog, ASchemaThatUsesDevicesSaysWhichItNeeds) {
  Registry registry;
  EXPECT_THROW(registry.add_schema<Careless>("careless"), std::logic_error);
  EXPECT_EQ(registry.catalog().find("careless"), nullptr);
}

TEST(Catalog, SettingsSayWhichDeviceTheyAreFor) {
  ComponentSpec spec{.name = "communication_port"};
  EXPECT_EQ(spec.device(), "communication_port");
  spec.configures = "comm_port";
  const auto read = catalog_from_json(catalog_to_json(Catalog{{spec}}));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read.value().find("communication_port")->device(), "comm_port");
}

TEST(Catalog, CarriesRolesAsWords) {
  Registry registry;
  registry.add_schema<Example>("example");
  const auto read = catalog_from_json(catalog_to_json(registry.catalog()));
  ASSERT_TRUE(read.ok()) << read.error().message;
  const auto* gains = read.value().find("example")->find(Role::kGain);
  ASSERT_NE(gains, nullptr);
  EXPECT_EQ(gains->name, "gains");
  EXPECT_EQ(gains->of, "inputs");
  EXPECT_EQ(read.value().find("example")->find(Role::kChannel), nullptr);
  for (int role = 0; role <= static_cast<int>(Role::kCameraForward); ++role)
    EXPECT_EQ(role_named(to_string(static_cast<Role>(role))), static_cast<Role>(role)) << role;
}

TEST(Catalog, TakesARoleThatItDoesNotKnowForNone) {
  const auto read = catalog_from_json(R"({"components":[{"name":"new","kind":"motor_schema",
      "attributes":[{"name":"a","type":"number","role":"warp_factor","of":"b"}]}]})");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read.value().find("new")->find("a")->role, Role::kNone);
}

/// Why a component with this attribute, a locate and a force is refused; empty if it is not.
std::string refusal(AttributeSpec attribute) {
  const AttributeSpec object{.name = "object",
                             .type = AttributeType::kName,
                             .refers_to = "locate",
                             .access = Access::kWrite};
  const AttributeSpec push{.name = "push", .type = AttributeType::kName, .refers_to = "force"};
  try {
    require_sound_roles({"example", ComponentKind::kMotorSchema, "", {attribute, object, push}});
    return {};
  } catch (const std::logic_error& problem) {
    return problem.what();
  }
}

TEST(Role, IsRefusedWhereTheAttributeCannotHaveIt) {
  const auto number = AttributeType::kNumber;
  const auto role = [](AttributeType type, Role of_attribute, std::string of) {
    return refusal({.name = "odd", .type = type, .role = of_attribute, .of = std::move(of)});
  };
  EXPECT_EQ(role(number, Role::kGain, "push"), "");
  EXPECT_EQ(role(number, Role::kCertaintyBelow, "object"), "");
  EXPECT_EQ(role(number, Role::kTimeAtLeast, ""), "");
  EXPECT_EQ(role(AttributeType::kText, Role::kGain, "push"),
            "'odd' of 'example' cannot have the role gain: it is of type text");
  EXPECT_EQ(
      role(number, Role::kGain, "nobody"),
      "'odd' of 'example' cannot have the role gain: it is of 'nobody', which is no attribute");
  EXPECT_EQ(
      role(number, Role::kGain, "object"),
      "'odd' of 'example' cannot have the role gain: it is of 'object', which names no force");
  EXPECT_EQ(role(AttributeType::kName, Role::kChannel, "red"),
            "'odd' of 'example' cannot have the role channel: it writes no image");
  EXPECT_EQ(role(AttributeType::kInteger, Role::kBumper, ""),
            "'odd' of 'example' cannot have the role bumper: it is not the index of a bit");
}

TEST(Role, OfAChannelNamesThePicturesEachOnceInTheirOrder) {
  const auto writes = [](std::string channel) {
    return AttributeSpec{.name = channel,
                         .type = AttributeType::kName,
                         .refers_to = "image",
                         .access = Access::kWrite,
                         .role = Role::kChannel,
                         .of = channel};
  };
  const Catalog catalog{
      {{"one", ComponentKind::kPerceptualSchema, "", {writes("b"), writes("a")}},
       {"two", ComponentKind::kPerceptualSchema, "", {writes("a"), writes("c")}}}};
  EXPECT_EQ(picture_channels(catalog), (std::vector<std::string>{"b", "a", "c"}));
}

TEST(Catalog, SaysWhichComponentOfBrokenJsonItCouldNotRead) {
  const auto read =
      catalog_from_json(R"({"components":[{"name":"noise","kind":"potato","attributes":[]}]})");
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().message.find("noise"), std::string::npos);
  EXPECT_NE(read.error().message.find("potato"), std::string::npos);
  EXPECT_FALSE(catalog_from_json("{").ok());
}

TEST(Registry, MakesASchemaWithItsAttributesAndVariables) {
  Registry registry;
  registry.add_schema<Example>("example");
  VariableStore store;
  auto& goal = store.add<Locate>("trash");
  auto& noise = store.add<Force>("noise");
  AttributeValues values;
  values.set("goal_variable", std::string("trash"));
  values.set("result", std::string());
  values.set("radius", 0.5);
  values.set("inputs", std::vector<std::string>{"noise"});
  values.set("mode", std::string("sum"));
  robot::FakeCommPort comm_port;
  robot::FakeMotorDrive motor_drive;
  robot::FakeFrameGrabber frame_grabber;
  const Devices devices{comm_port, motor_drive, frame_grabber};
  const auto schema = registry.make("example", values, {store, devices, Random(1)});
  const auto& example = dynamic_cast<Example&>(*schema);
  EXPECT_EQ(example.goal_, &goal);
  EXPECT_EQ(example.result_, nullptr);
  EXPECT_EQ(example.radius_m_, 0.5);
  EXPECT_EQ(example.inputs_, std::vector<const Variable<Force>*>{&noise});
  EXPECT_TRUE(example.sum_);
  EXPECT_EQ(registry.make("nothing", values, {store, devices, Random(1)}), nullptr);
}

TEST(Unit, IsFoundBySymbol) {
  EXPECT_EQ(find_unit("cm")->to_si, 0.01);
  EXPECT_EQ(find_unit("ticks/cm")->dimension, std::string_view("encoder resolution"));
  EXPECT_FALSE(find_unit("furlong").has_value());
}

}  // namespace
}  // namespace galilean
