// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "tests/monitor/map/truth/mapped_contest.h"

namespace galilean::monitor {

/// A sum of squares, of errors or of Mahalanobis distances.
struct Squares {
  double sum = 0;
  std::size_t count = 0;

  void add(double square) {
    sum += square;
    ++count;
  }
  void add(const Squares& other) {
    sum += other.sum;
    count += other.count;
  }
  [[nodiscard]] double mean() const { return count ? sum / static_cast<double>(count) : 0; }
  [[nodiscard]] double rms() const { return std::sqrt(mean()); }
};

/// How a map compares with the world over some time. NEES is the mean squared Mahalanobis distance
/// between truth and estimate. It is 2 if the covariances are right.
struct Figures {
  Squares robot_m2, robot_nees, dead_reckoning_m2;
  Squares trash_m2, trash_nees;    ///< of trash that was seen in the last kLately_s
  Squares basket_m2, basket_nees;  ///< of all baskets that are published
  std::size_t published = 0;       ///< trash in the map that was seen in the last kLately_s
  std::size_t right = 0;           ///< how many of those are there
  std::size_t real = 0;            ///< trash that robots truly saw in the last kLately_s
  std::size_t found = 0;           ///< how many of those are in the map
  std::size_t all_published = 0, all_real = 0, baskets_published = 0, baskets_right = 0, looks = 0;

  static constexpr double kLately_s = 10;
  static constexpr double kSame_m =
      0.30;  ///< a published landmark this near to an object counts as that object

  void add(const Figures& other);
  [[nodiscard]] double precision() const {
    return published ? double(right) / double(published) : 1;
  }
  [[nodiscard]] double recall() const { return real ? double(found) / double(real) : 1; }
};

/// Compares a mapped contest with the truth, each second from `from_s` to `to_s` of the contest.
class TruthWatch {
 public:
  TruthWatch(MappedContest& contest, double from_s, double to_s);
  void look(const MappedContest& contest, const msg::ObjectMap& map);
  [[nodiscard]] const Figures& figures() const noexcept { return figures_; }

 private:
  void note_seen(const MappedContest& contest, std::size_t robot, const msg::Sightings& frame);
  void look_at_robots(const MappedContest& contest, const msg::ObjectMap& map);
  void look_at_trash(const MappedContest& contest, const msg::ObjectMap& map);
  void look_at_baskets(const MappedContest& contest, const msg::ObjectMap& map);

  double from_s_, to_s_;
  std::map<std::size_t, Time> seen_;  ///< when a robot last truly saw the piece with this index
  Figures figures_;
};

}  // namespace galilean::monitor
