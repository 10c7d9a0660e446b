// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "tests/monitor/map/truth/mapped_contest.h"

namespace galilean::monitor {

/// Sums of squares, of errors or of Mahalanobis distances.
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

/// How well a map agrees with the world over some time. The NEES is the mean squared Mahalanobis
/// distance between truth and estimate. It is 2 if the covariances describe the errors correctly.
struct Figures {
  Squares robot_m2, robot_nees, dead_reckoning_m2;
  Squares trash_m2, trash_nees;    ///< trash seen in the last kLately_s
  Squares basket_m2, basket_nees;  ///< all published baskets
  std::size_t published = 0;       ///< trash in the map that was seen in the last kLately_s
  std::size_t right = 0;           ///< how many of `published` exist
  std::size_t real = 0;            ///< trash that robots truly saw in the last kLately_s
  std::size_t found = 0;           ///< how many of `real` are in the map
  std::size_t all_published = 0, all_real = 0, baskets_published = 0, baskets_right = 0, looks = 0;

  static constexpr double kLately_s = 10;
  /// A published landmark that is nearer than this to a real object stands for it.
  static constexpr double kSame_m = 0.30;

  void add(const Figures& other);
  [[nodiscard]] double precision() const {
    return published ? double(right) / double(published) : 1;
  }
  [[nodiscard]] double recall() const { return real ? double(found) / double(real) : 1; }
};

/// Compares the map of a contest with the truth, each second from `from_s` to `to_s`.
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
  std::map<std::size_t, Time> seen_;  ///< by piece of trash: when a robot last truly saw it
  Figures figures_;
};

}  // namespace galilean::monitor
