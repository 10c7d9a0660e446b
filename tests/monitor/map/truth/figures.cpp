// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/map/truth/figures.h"

#include <Eigen/LU>
#include <algorithm>

namespace galilean::monitor {
namespace {

struct Body {
  std::size_t index;
  Vec2 at_m;
};

std::vector<Body> pieces(const MappedContest& contest) {
  std::vector<Body> result;
  const auto& all = contest.contest().world().objects().pieces();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].body) result.push_back({i, sim::pose_of(*all[i].body).position_m});
  return result;
}

std::vector<Body> baskets(const MappedContest& contest) {
  std::vector<Body> result;
  for (const auto* body : contest.contest().world().objects().baskets())
    result.push_back({result.size(), sim::pose_of(*body).position_m});
  return result;
}

double nees(const auto& published, const Vec2& truth_m) {
  Mat2 covariance;
  covariance << published.variance_xx, published.variance_xy, published.variance_xy,
      published.variance_yy;
  const Vec2 apart = Vec2(published.x_m, published.y_m) - truth_m;
  return apart.dot(covariance.inverse() * apart);
}

double seconds(const msg::Time& time) {
  return time.sec + 1e-9 * time.nanosec;
}

struct Match {
  double distance_m;
  const msg::MapObject* published;
  const Body* body;
};

/// Returns each published landmark with at most one body. The nearest pairs are matched first.
std::vector<Match> matched(const std::vector<const msg::MapObject*>& published,
                           const std::vector<Body>& bodies) {
  std::vector<Match> all, result;
  for (const auto* landmark : published)
    for (const auto& body : bodies)
      if (const double apart_m = (Vec2(landmark->x_m, landmark->y_m) - body.at_m).norm();
          apart_m < Figures::kSame_m)
        all.push_back({apart_m, landmark, &body});
  std::ranges::sort(all, {}, &Match::distance_m);
  std::set<const void*> taken;
  for (const auto& match : all)
    if (!taken.contains(match.published) && !taken.contains(match.body)) {
      taken.insert({match.published, match.body});
      result.push_back(match);
    }
  return result;
}

std::vector<const msg::MapObject*> of_class(const msg::ObjectMap& map, const char* object_class) {
  std::vector<const msg::MapObject*> result;
  for (const auto& object : map.objects)
    if (object.object_class == object_class) result.push_back(&object);
  return result;
}

}  // namespace

void Figures::add(const Figures& other) {
  robot_m2.add(other.robot_m2);
  robot_nees.add(other.robot_nees);
  dead_reckoning_m2.add(other.dead_reckoning_m2);
  trash_m2.add(other.trash_m2);
  trash_nees.add(other.trash_nees);
  basket_m2.add(other.basket_m2);
  basket_nees.add(other.basket_nees);
  published += other.published;
  right += other.right;
  real += other.real;
  found += other.found;
  all_published += other.all_published;
  all_real += other.all_real;
  baskets_published += other.baskets_published;
  baskets_right += other.baskets_right;
  looks += other.looks;
}

TruthWatch::TruthWatch(MappedContest& contest, double from_s, double to_s)
    : from_s_(from_s), to_s_(to_s) {
  contest.on_sightings.push_back([this, &contest](std::size_t robot, const msg::Sightings& frame) {
    note_seen(contest, robot, frame);
  });
}

void TruthWatch::note_seen(const MappedContest& contest, std::size_t robot,
                           const msg::Sightings& frame) {
  const Pose2 pose = contest.contest().world().robot(robot).pose();
  const auto bodies = pieces(contest);
  for (const auto& item : frame.items) {
    if (item.object_class != "trash") continue;
    const Vec2 in_robot_m =
        rotated(Vec2(item.x_m - frame.x_m, item.y_m - frame.y_m), -frame.heading_rad);
    const Vec2 at_m = pose.position_m + rotated(in_robot_m, pose.heading_rad);
    const auto nearest = std::ranges::min_element(
        bodies, {}, [&](const Body& body) { return (body.at_m - at_m).norm(); });
    if (nearest != bodies.end() && (nearest->at_m - at_m).norm() < Figures::kSame_m)
      seen_[nearest->index] = contest.now();
  }
}

void TruthWatch::look(const MappedContest& contest, const msg::ObjectMap& map) {
  const double elapsed_s = contest.contest().simulated_s();
  if (elapsed_s < from_s_ || elapsed_s > to_s_) return;
  ++figures_.looks;
  look_at_robots(contest, map);
  look_at_trash(contest, map);
  look_at_baskets(contest, map);
}

void TruthWatch::look_at_robots(const MappedContest& contest, const msg::ObjectMap& map) {
  for (std::size_t i = 0; i < contest.contest().robot_count(); ++i) {
    const auto& robot = contest.contest().robot(i);
    const Vec2 truth_m = robot.body().pose().position_m;
    figures_.dead_reckoning_m2.add((robot.believed_pose().position_m - truth_m).squaredNorm());
    const auto published = std::ranges::find(map.robots, robot.name(), &msg::MapRobot::name);
    if (published == map.robots.end()) continue;
    figures_.robot_m2.add((Vec2(published->x_m, published->y_m) - truth_m).squaredNorm());
    figures_.robot_nees.add(nees(*published, truth_m));
  }
}

void TruthWatch::look_at_trash(const MappedContest& contest, const msg::ObjectMap& map) {
  const auto bodies = pieces(contest);
  const auto all = of_class(map, "trash");
  figures_.all_published += all.size();
  figures_.all_real += bodies.size();
  const auto pairs = matched(all, bodies);
  const auto lately = [&](const msg::MapObject* published) {
    return seconds(map.stamp) - seconds(published->last_seen) < Figures::kLately_s;
  };
  figures_.published += static_cast<std::size_t>(std::ranges::count_if(all, lately));
  for (const auto& pair : pairs) {
    if (!lately(pair.published)) continue;
    ++figures_.right;
    figures_.trash_m2.add(pair.distance_m * pair.distance_m);
    figures_.trash_nees.add(nees(*pair.published, pair.body->at_m));
  }
  for (const auto& body : bodies) {
    const auto seen = seen_.find(body.index);
    if (seen == seen_.end() || to_seconds(contest.now() - seen->second) > Figures::kLately_s)
      continue;
    ++figures_.real;
    figures_.found += std::ranges::count(pairs, &body, &Match::body) > 0;
  }
}

void TruthWatch::look_at_baskets(const MappedContest& contest, const msg::ObjectMap& map) {
  const auto bodies = baskets(contest);
  const auto published = of_class(map, "basket");
  figures_.baskets_published += published.size();
  for (const auto& pair : matched(published, bodies)) {
    ++figures_.baskets_right;
    figures_.basket_m2.add(pair.distance_m * pair.distance_m);
    figures_.basket_nees.add(nees(*pair.published, pair.body->at_m));
  }
}

}  // namespace galilean::monitor
