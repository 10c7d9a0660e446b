// SPDX-License-Identifier: BSD-3-Clause
// The map's files, read back by others' readers: MRPT, and the rule of ROS' map_server.
#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/CCylinder.h>
#include <mrpt/opengl/CEllipsoid2D.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <fstream>
#include <sstream>

#include "monitor/map/export/map_files.h"
#include "monitor/map/export/map_scene.h"
#include "monitor/map/export/markers.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

class MapFilesTest : public testing::Test {
 protected:
  MapFilesTest() {
    grid.info.resolution = 0.05F;
    grid.info.width = 3;
    grid.info.height = 2;
    grid.info.origin.position.x = -1;
    grid.info.origin.position.y = 2;
    grid.data = {0, 100, -1, 10, 80, 50};  // the southern row first
    map.objects.push_back({.id = 7,
                           .object_class = "trash",
                           .x_m = 1,
                           .y_m = -2,
                           .variance_xx = 0.04,
                           .variance_xy = 0,
                           .variance_yy = 0.01,
                           .certainty = 0.5F});
    map.robots.push_back({.name = "io", .x_m = 3, .y_m = 4, .heading_rad = 1});
  }
  std::string written(const std::string& name, const std::string& content) const {
    std::ofstream(folder / name, std::ios::binary) << content;
    return folder / name;
  }
  /// "0.196" of "free_thresh: 0.196".
  static double yaml_number(const std::string& yaml, const std::string& key) {
    const auto at = yaml.find("\n" + key + ": ");
    return at == yaml.npos ? -1 : std::stod(yaml.substr(at + key.size() + 3));
  }

  const TemporaryFolder folder;
  msg::OccupancyGrid grid;
  msg::ObjectMap map;
};

TEST_F(MapFilesTest, MapServerReadsFreeOccupiedAndUnknownWhereTheyAre) {
  mrpt::img::CImage picture;
  ASSERT_TRUE(picture.loadFromFile(written("map.png", map_png(grid))));
  ASSERT_EQ(picture.getWidth(), 3U);
  ASSERT_EQ(picture.getHeight(), 2U);
  const auto yaml = map_yaml(grid);
  const auto read = [&](unsigned column, unsigned row_from_north) {
    const double occupied = (255 - *picture.ptr<std::uint8_t>(column, row_from_north)) / 255.0;
    return occupied > yaml_number(yaml, "occupied_thresh") ? 100
           : occupied < yaml_number(yaml, "free_thresh")   ? 0
                                                           : -1;
  };
  EXPECT_EQ(read(0, 1), 0);
  EXPECT_EQ(read(1, 1), 100);
  EXPECT_EQ(read(2, 1), -1);
  EXPECT_EQ(read(0, 0), 0);
  EXPECT_EQ(read(1, 0), 100);
  EXPECT_EQ(read(2, 0), -1);
  EXPECT_NE(yaml.find("origin: [-1, 2, 0]"), yaml.npos) << yaml;
  EXPECT_NE(yaml.find("image: map.png"), yaml.npos) << yaml;
}

TEST_F(MapFilesTest, MrptOpensTheSceneAndFindsThingsAndRobots) {
  mrpt::opengl::COpenGLScene scene;
  ASSERT_TRUE(scene.loadFromFile(written("map.3Dscene", map_scene(grid, map))));
  EXPECT_TRUE(scene.getByName("floor"));
  const auto can = std::dynamic_pointer_cast<mrpt::opengl::CCylinder>(scene.getByName("trash 7"));
  ASSERT_TRUE(can);
  EXPECT_DOUBLE_EQ(can->getPoseX(), 1);
  EXPECT_DOUBLE_EQ(can->getPoseY(), -2);
  EXPECT_NEAR(can->getColor().A, 0.5, 0.01);
  const auto body = std::dynamic_pointer_cast<mrpt::opengl::CBox>(scene.getByName("io"));
  ASSERT_TRUE(body);
  EXPECT_NEAR(body->getPose().yaw, 1, 1e-9);
  const auto ellipse = scene.getByClass<mrpt::opengl::CEllipsoid2D>();
  ASSERT_TRUE(ellipse);
  EXPECT_NEAR(ellipse->getCovMatrix()(0, 0), 0.04, 1e-6);
}

TEST_F(MapFilesTest, ASceneWithoutAFloorIsOneToo) {
  mrpt::opengl::COpenGLScene scene;
  EXPECT_TRUE(scene.loadFromFile(written("map.3Dscene", map_scene({}, map))));
}

TEST_F(MapFilesTest, MarkersShowEachObjectAndRobotWithItsEllipse) {
  const auto shown = markers(map).markers;
  ASSERT_EQ(shown.size(), 5U);
  const auto& ellipse = shown[1];
  EXPECT_EQ(ellipse.ns, "object_ellipses");
  EXPECT_NEAR(ellipse.scale.x, 2 * 2.4477 * 0.2, 1e-6) << "the longer axis lies along x";
  EXPECT_NEAR(ellipse.scale.y, 2 * 2.4477 * 0.1, 1e-6);
  EXPECT_NEAR(ellipse.pose.orientation.z, 0, 1e-9);
  map.objects[0].variance_xx = map.objects[0].variance_yy = 0.02;
  map.objects[0].variance_xy = 0.01;
  EXPECT_NEAR(markers(map).markers[1].pose.orientation.z, std::sin(3.14159265 / 8), 1e-6)
      << "45 degrees";
}

}  // namespace
}  // namespace galilean::monitor
