#include "monitor/map/estimation/starts.h"

namespace galilean::monitor {
namespace {

/// How well a person places a robot, or says where it is.
constexpr double kPlaced_m = 0.06;
constexpr double kPlaced_rad = 0.15;
/// Of the one whose frame is the map's.
constexpr double kReference = 1e-3;
/// Of robots of which nothing is said.
constexpr double kGuessed_m = 0.15;
constexpr double kGuessed_rad = 0.2;

}  // namespace

Starts::Start Starts::of(const std::string& robot) const {
  if (const auto given = given_.find(robot); given != given_.end())
    return {given->second, kPlaced_m, kPlaced_rad};
  if (!given_.empty()) return {given_.begin()->second, kGuessed_m, kGuessed_rad};
  if (robot == first_heard_) return {{}, kReference, kReference, true};
  return {{}, kGuessed_m, kGuessed_rad};
}

}  // namespace galilean::monitor
