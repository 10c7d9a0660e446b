// SPDX-License-Identifier: BSD-3-Clause
// Pushes over HTTP that the simulator tries first: the real one, with the components that ship.
#include <fstream>
#include <iterator>

#include "bhdl/program/catalog_file.h"
#include "tests/monitor/scripted_robot.h"
#include "tests/monitor/server/server_fixture.h"

namespace galilean::monitor {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// Costs nothing and brings nothing.
constexpr const char* kStands = "states:\n  state:\n    name: \"start\"\n  end\nend\n";
/// Drives straight on until it hits a wall, which costs a point.
constexpr const char* kRams = R"(input_devices: comm_port: end end
output_devices: motor_drive: end end
variables:
  shaft: name: "shaft" status: "valid" certainty: 1
  force: name: "ahead"
end
motor_schemas:
  noise: name: "noise" shaft_variable: "shaft" persistence: 600 result: "ahead" end
  move_robot: name: "move" input_force: "ahead" shaft_variable: "shaft" end
end
states: state: name: "start" motor_schemas: "noise" "move" end end end
)";

/// Four simulators take less than a second each on a machine that has nothing else to do.
constexpr auto kPatience = std::chrono::seconds(100);

class PushingWithATrialTest : public ServerFixture {
 protected:
  void change(MonitorOptions& options) override {
    options.simulator = GALILEAN_SIM;
    options.catalog_file = bhdl::default_catalog_path();
  }
  void SetUp() override {
    ServerFixture::SetUp();
    std::ifstream in(bhdl::default_catalog_path());
    io.emplace("io", test_domain(), std::string(std::istreambuf_iterator<char>(in), {}));
    wait_for_robots(1);
    const auto first = post("/api/push", {{"files", files(kStands)}});
    ASSERT_EQ(first.status, 200U) << first.body;
    ASSERT_TRUE(becomes_true([&] { return place_is_known(); }));
  }

  [[nodiscard]] bool place_is_known() { return get("/api/map.yaml").status == 200; }

  /// Pushes what rams walls, and waits for the end.
  json push_worse(json trial) {
    trial.update({{"seeds", 2}, {"duration_s", 20}, {"scenario", "office"}});
    const auto accepted = post("/api/push", {{"files", files(kRams)}, {"try", trial}});
    EXPECT_EQ(accepted.status, 202U) << accepted.body;
    const std::string id = accepted.as_json()["id"];
    EXPECT_TRUE(becomes_true([&] { return push_named(id)["state"] != "running"; }, kPatience));
    return push_named(id);
  }

  std::optional<ScriptedRobot> io;
};

TEST_F(PushingWithATrialTest, AProgramThatScoresWorseReachesNoRobot) {
  const auto before = io->running_hash();
  const auto push = push_worse(json::object());
  EXPECT_EQ(push["state"], "failed");
  EXPECT_EQ(push["steps"][1]["name"], "try");
  EXPECT_EQ(push["steps"][1]["state"], "failed");
  EXPECT_EQ(
      push["steps"][1]["detail"],
      "in simulation it scores -1 ± 0; the program that runs now scores 0 ± 0 (2 runs of 20 s)");
  EXPECT_EQ(push["steps"][3]["state"], "left_out");
  EXPECT_EQ(push["trial"]["runs"], 2);
  EXPECT_EQ(push["trial"]["next"]["score"]["mean"], -1.0);
  EXPECT_EQ(push["trial"]["next"]["collisions"]["mean"], 1.0);
  EXPECT_EQ(push["trial"]["now"]["score"]["mean"], 0.0);
  EXPECT_EQ(io->running_hash(), before);
}

TEST_F(PushingWithATrialTest, EvenIfWorseItIsPushedAllTheSame) {
  const auto push = push_worse({{"even_if_worse", true}});
  EXPECT_EQ(push["state"], "done") << push.dump();
  EXPECT_THAT(push["steps"][1]["detail"].get<std::string>(), StartsWith("scores -1 ± 0"));
  EXPECT_EQ(io->running_hash(), push["hash"]);
}

TEST_F(PushingWithATrialTest, OnlyTriedItReachesNoRobotAndIsNoFailure) {
  const auto before = io->running_hash();
  const auto push = push_worse({{"only", true}});
  EXPECT_EQ(push["state"], "done") << push.dump();
  EXPECT_THAT(push["steps"][1]["detail"].get<std::string>(), StartsWith("scores -1 ± 0"));
  EXPECT_EQ(push["steps"][3]["state"], "left_out");
  EXPECT_EQ(io->running_hash(), before);
  ASSERT_TRUE(becomes_true([&] {
    const auto newest = get("/api/pushes").as_json()["pushes"][0];
    return newest["id"] == push["id"] && newest["trial"] == push["trial"];
  })) << "what was found is remembered";
}

}  // namespace
}  // namespace galilean::monitor
