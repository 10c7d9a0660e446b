// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/export/map_scene.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/opengl/CBox.h>
#include <mrpt/opengl/CCylinder.h>
#include <mrpt/opengl/CEllipsoid2D.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CText.h>
#include <mrpt/opengl/stock_objects.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>

#include "monitor/compression/gzip.h"
#include "monitor/map/export/appearance.h"

namespace galilean::monitor {
namespace {

using mrpt::opengl::COpenGLScene;

constexpr double kAboveFloor_m = 0.005;  ///< keeps the floor from hiding the ellipses
constexpr int kSides = 24;
constexpr float kOneHalf = 0.5F;

void add_floor(COpenGLScene& scene, const msg::OccupancyGrid& grid) {
  if (grid.data.empty()) return;
  const auto& info = grid.info;
  const auto left_m = static_cast<float>(info.origin.position.x);
  const auto bottom_m = static_cast<float>(info.origin.position.y);
  mrpt::maps::COccupancyGridMap2D cells;
  cells.setSize(left_m, left_m + info.resolution * static_cast<float>(info.width), bottom_m,
                bottom_m + info.resolution * static_cast<float>(info.height), info.resolution);
  const auto width = std::min(cells.getSizeX(), info.width);
  const auto height = std::min(cells.getSizeY(), info.height);
  for (unsigned row = 0; row < height; ++row)
    for (unsigned column = 0; column < width; ++column) {
      const std::int8_t occupied_percent = grid.data[row * std::size_t{info.width} + column];
      const float free =
          occupied_percent < 0 ? kOneHalf : 1 - static_cast<float>(occupied_percent) / 100;
      cells.setCell(static_cast<int>(column), static_cast<int>(row), free);
    }
  auto drawn = mrpt::opengl::CSetOfObjects::Create();
  drawn->setName("floor");
  cells.getVisualizationInto(*drawn);
  scene.insert(drawn);
}

void add_ellipse(COpenGLScene& scene, const auto& at) {
  auto ellipse = mrpt::opengl::CEllipsoid2D::Create();
  mrpt::math::CMatrixDouble22 covariance_m2;
  covariance_m2(0, 0) = at.variance_xx;
  covariance_m2(1, 1) = at.variance_yy;
  covariance_m2(0, 1) = covariance_m2(1, 0) = at.variance_xy;
  ellipse->setQuantiles(static_cast<float>(kEllipseDeviations));
  ellipse->setCovMatrix(covariance_m2);
  ellipse->setLocation(at.x_m, at.y_m, kAboveFloor_m);
  ellipse->setColor(0.2, 0.2, 0.2);
  scene.insert(ellipse);
}

void add_object(COpenGLScene& scene, const msg::MapObject& object) {
  const Appearance appearance = appearance_of(object.object_class);
  const auto radius_m = static_cast<float>(appearance.diameter_m / 2);
  auto cylinder = mrpt::opengl::CCylinder::Create(radius_m, radius_m,
                                                  static_cast<float>(appearance.height_m), kSides);
  cylinder->setName(object.object_class + " " + std::to_string(object.id));
  cylinder->setLocation(object.x_m, object.y_m, 0);
  cylinder->setColor(appearance.red, appearance.green, appearance.blue,
                     std::max(object.certainty, kLeastOpacity));
  scene.insert(cylinder);
  add_ellipse(scene, object);
}

void add_robot(COpenGLScene& scene, const msg::MapRobot& robot) {
  using mrpt::math::TPoint3D;
  constexpr double kX = Body::kLength_m / 2, kY = Body::kWidth_m / 2;
  auto body = mrpt::opengl::CBox::Create(TPoint3D(-kX, -kY, 0), TPoint3D(kX, kY, Body::kHeight_m));
  body->setName(robot.name);
  body->setPose(mrpt::math::TPose3D(robot.x_m, robot.y_m, 0, robot.heading_rad, 0, 0));
  body->setColor(Body::kRed, Body::kGreen, Body::kBlue, robot.silent ? Body::kSilentOpacity : 1);
  scene.insert(body);
  auto name = mrpt::opengl::CText::Create(robot.name);
  name->setLocation(robot.x_m, robot.y_m, Body::kHeight_m + 0.1);
  scene.insert(name);
  add_ellipse(scene, robot);
}

}  // namespace

std::string map_scene(const msg::OccupancyGrid& grid, const msg::ObjectMap& map) {
  COpenGLScene scene;
  add_floor(scene, grid);
  for (const auto& object : map.objects) add_object(scene, object);
  for (const auto& robot : map.robots) add_robot(scene, robot);
  scene.insert(mrpt::opengl::stock_objects::CornerXYZSimple(1));  // the map frame, axes of 1 m

  mrpt::io::CMemoryStream file;
  mrpt::serialization::archiveFrom(file) << scene;
  constexpr int kQuick = 1;
  return gzipped({static_cast<const char*>(file.getRawBufferData()), file.getTotalBytesCount()},
                 kQuick);
}

}  // namespace galilean::monitor
