// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <random>

#include "core/json_text.h"
#include "core/wire/schemas.h"
#include "core/wire/types/own_types.h"
#include "core/wire/types/type_text.h"
#include "monitor/schemas/message_trees.h"
#include "monitor/schemas/ros2idl.h"
#include "monitor/schemas/ros2msg.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;

/// Writes little-endian CDR by hand, so that the test does not rest on what it tests.
struct Cdr {
  std::vector<std::uint8_t> bytes{0, 1, 0, 0};
  template <class Number>
  Cdr& add(Number number) {
    while ((bytes.size() - 4) % sizeof number != 0) bytes.push_back(0);
    const auto* raw = reinterpret_cast<const std::uint8_t*>(&number);
    bytes.insert(bytes.end(), raw, raw + sizeof number);
    return *this;
  }
  Cdr& text(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size() + 1));
    bytes.insert(bytes.end(), text.begin(), text.end());
    bytes.push_back(0);
    return *this;
  }
};

mcap::Summary recording_of(const mcap::Schema& schema, const std::string& encoding = "cdr") {
  mcap::Summary summary;
  summary.schemas[1] = schema;
  summary.channels[1] = {1, 1, "/t", encoding, {}};
  return summary;
}

/// Returns the message as JSON, or why it cannot be decoded.
std::string decoded(const mcap::Schema& schema, const std::vector<std::uint8_t>& cdr) {
  const auto tree = MessageTrees(recording_of(schema)).decode({.channel_id = 1, .data = cdr});
  return tree ? ordered_json_text(tree.value()) : tree.error().message;
}

/// The types that this release knows are described twice: by Cyclone, and by their text.
TEST(Schemas, AnOwnTypeIsReadFromItsTextAsItIs) {
  for (const auto& schema : wire::schemas()) {
    const auto definitions = parse_ros2idl(schema.idl);
    ASSERT_TRUE(definitions.ok()) << schema.ros_type << " " << definitions.error().message;
    const auto type = make_type(definitions.value(), scoped_name(schema.ros_type));
    ASSERT_TRUE(type.ok()) << schema.ros_type << " " << type.error().message;
    const auto* own = wire::find_own_type(schema.dds_type);
    ASSERT_NE(own, nullptr) << schema.ros_type;
    ASSERT_EQ(type.value()->members.size(), own->description->members.size()) << schema.ros_type;
    for (std::size_t i = 0; i < type.value()->members.size(); ++i) {
      const auto& read = type.value()->members[i];
      const auto& known = own->description->members[i];
      EXPECT_EQ(read.name, known.name) << schema.ros_type;
      EXPECT_EQ(read.type->kind, known.type->kind) << schema.ros_type << "." << read.name;
      EXPECT_EQ(read.type->bytes, known.type->bytes) << schema.ros_type << "." << read.name;
      EXPECT_EQ(read.type->bounds, known.type->bounds) << schema.ros_type << "." << read.name;
    }
  }
}

TEST(Schemas, ReadsTheMessageFilesOfRos2) {
  const mcap::Schema schema{1, "a_msgs/msg/Scan", "ros2msg",
                            "# what a scanner sees\n"
                            "uint8 NEAR=1\n"
                            "string KIND = \"a # b\"\n"
                            "Header header\n"
                            "float32[3] corner   # of the box\n"
                            "int16[] counts\n"
                            "string<=5 unit \"m\"\n"
                            "Reading[<=2] readings\n"
                            "char letter\r\n"
                            "Nothing nothing\n"
                            "================\n"
                            "MSG: std_msgs/Header\n"
                            "uint32 seq\n"
                            "===\n"
                            "MSG: a_msgs/Reading\n"
                            "bool valid\n"
                            "float64 range_m\n"
                            "===\n"
                            "MSG: a_msgs/Nothing\n"};
  Cdr cdr;
  cdr.add(7U).add(1.5F).add(2.5F).add(-1.0F);
  cdr.add(2U).add(std::int16_t{-3}).add(std::int16_t{4}).text("mm");
  cdr.add(1U).add(true).add(0.25).add(std::uint8_t{65}).add(std::uint8_t{0});
  EXPECT_EQ(decoded(schema, cdr.bytes),
            R"({"header":{"seq":7},"corner":[1.5,2.5,-1.0],"counts":[-3,4],"unit":"mm",)"
            R"("readings":[{"valid":true,"range_m":0.25}],"letter":65,)"
            R"("nothing":{"structure_needs_at_least_one_member":0}})");
}

TEST(Schemas, ReadsAliasesEnumsConstantsAndBases) {
  const mcap::Schema schema{1, "a_msgs/msg/Job", "ros2idl",
                            "#include \"x.idl\"\n"
                            "module a_msgs { module msg {\n"
                            "  /* two\n lines */ const unsigned long MOST = 2;\n"
                            "  typedef double pair[MOST];\n"
                            "  enum Phase { IDLE, @value(7) BUSY, DONE };\n"
                            "  struct Base { octet kind; };\n"
                            "  @verbatim (language=\"comment\", text=\"a ; b }\")\n"
                            "  struct Job : Base {\n"
                            "    @default (value=0.5) pair place; // where\n"
                            "    sequence<sequence<short, 3>> lists;\n"
                            "    a_msgs::msg::Phase phase, next;\n"
                            "    other_msgs::msg::Point at; unsigned long long big;\n"
                            "  }; }; };\n"
                            "================\n"
                            "IDL: other_msgs/msg/Point\n"
                            "module other_msgs { module msg { struct Point { float x; }; }; };\n"};
  Cdr cdr;
  cdr.add(std::uint8_t{9}).add(1.5).add(2.5).add(1U).add(2U);
  cdr.add(std::int16_t{5})
      .add(std::int16_t{6})
      .add(7U)
      .add(8U)
      .add(0.5F)
      .add(std::uint64_t{1} << 40);
  EXPECT_EQ(decoded(schema, cdr.bytes),
            R"({"kind":9,"place":[1.5,2.5],"lists":[[5,6]],"phase":"BUSY","next":"DONE",)"
            R"("at":{"x":0.5},"big":1099511627776})");
}

TEST(Schemas, SaysWhatCannotBeRead) {
  const auto idl = [](const std::string& text) {
    return decoded({1, "a/msg/B", "ros2idl", text}, {0, 1, 0, 0});
  };
  EXPECT_THAT(idl("module a { module msg { union B switch (long) { case 1: long x; }; }; };"),
              HasSubstr("their type, a/msg/B, holds a union"));
  EXPECT_THAT(idl("module a { module msg { struct B { C c; }; }; };"),
              HasSubstr("needs C, which is not there"));
  EXPECT_THAT(idl("module a { module msg { struct B { B b; }; }; };"), HasSubstr("holds itself"));
  EXPECT_THAT(idl("module a { struct"), HasSubstr("has a schema that ends where a name is"));
  EXPECT_THAT(idl("struct B { long 5; };"), HasSubstr("has '5' where a name is expected"));
  EXPECT_THAT(decoded({1, "a/msg/B", "protobuf", ""}, {}),
              HasSubstr("is in the encoding 'protobuf', which is not read here"));
  EXPECT_THAT(decoded({1, "a/msg/B", "ros2msg", "int32\n"}, {}),
              HasSubstr("has the line 'int32', which defines no field"));
  EXPECT_THAT(decoded({1, "a/msg/B", "ros2msg", "int32 x\n"}, {0, 1, 0, 0, 1}),
              HasSubstr("a message is not a whole a::msg::B"));
}

TEST(Schemas, ReadsJson) {
  const std::string text = R"({"x": [1, 2]})";
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  const MessageTrees trees(recording_of({}, "json"));
  EXPECT_EQ(ordered_json_text(trees.decode({.channel_id = 1, .data = bytes}).value()),
            R"({"x":[1,2]})");
  EXPECT_FALSE(trees.decode({.channel_id = 1}).ok());
  EXPECT_FALSE(trees.decode({.channel_id = 2, .data = bytes}).ok());
}

TEST(Schemas, NoTextBreaksTheReaders) {
  const auto whole = std::string(wire::find_schema_by_ros_type("galilean_msgs/msg/Variables")->idl);
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    auto text = whole.substr(0, random() % whole.size());
    for (int change = 0; change < 3 && !text.empty(); ++change)
      text[random() % text.size()] = "{}<>@();:,\"/*=#x1 \n"[random() % 19];
    for (const char* encoding : {"ros2idl", "ros2msg"})
      (void)decoded({1, "galilean_msgs/msg/Variables", encoding, text}, {0, 1, 0, 0, 5, 0, 0, 0});
  }
  EXPECT_FALSE(parse_ros2idl(std::string(100'000, '{')).ok());
  std::string deep = "struct B { ";
  for (int i = 0; i < 100'000; ++i) deep += "sequence<";
  EXPECT_FALSE(parse_ros2idl(deep).ok());
  deep.clear();
  for (int i = 0; i < 100'000; ++i) deep += "module a { ";
  EXPECT_FALSE(parse_ros2idl(deep).ok());
}

}  // namespace
}  // namespace galilean::monitor
