#include "monitor/map/rigid_fit.h"

#include <mrpt/poses/CPosePDFSOG.h>
#include <mrpt/random/RandomGenerators.h>
#include <mrpt/tfest/TMatchingPair.h>
#include <mrpt/tfest/se2.h>

#include <algorithm>

namespace galilean::monitor {
namespace {

mrpt::tfest::TMatchingPairList to_mrpt(const std::vector<PointPair>& pairs) {
  mrpt::tfest::TMatchingPairList list;
  for (const auto& pair : pairs)
    list.emplace_back(
        static_cast<std::uint32_t>(pair.map_index), static_cast<std::uint32_t>(pair.other_index),
        static_cast<float>(pair.in_map_m.x()), static_cast<float>(pair.in_map_m.y()), 0.0F,
        static_cast<float>(pair.in_other_m.x()), static_cast<float>(pair.in_other_m.y()), 0.0F);
  return list;
}

std::vector<PointPair> chosen(const std::vector<PointPair>& pairs,
                              const mrpt::tfest::TMatchingPairList& subset) {
  std::vector<PointPair> result;
  for (const auto& pair : pairs)
    if (std::ranges::any_of(subset, [&](const auto& each) {
          return each.globalIdx == pair.map_index && each.localIdx == pair.other_index;
        }))
      result.push_back(pair);
  return result;
}

}  // namespace

double spread_of(const std::vector<PointPair>& pairs) {
  double spread_m = 0;
  for (const auto& a : pairs)
    for (const auto& b : pairs) spread_m = std::max(spread_m, (a.in_other_m - b.in_other_m).norm());
  return spread_m;
}

RigidFit fit_rigidly(const std::vector<PointPair>& pairs, double deviation_m, std::size_t least) {
  RigidFit fit;
  if (pairs.size() < std::max<std::size_t>(least, 2)) return fit;
  mrpt::tfest::TSE2RobustParams parameters;
  parameters.ransac_minSetSize = static_cast<unsigned>(least);
  parameters.ransac_maxSetSize = static_cast<unsigned>(pairs.size());
  parameters.ransac_min_nSimulations = 300;
  mrpt::random::getRandomGenerator().randomize(1);  // the same pairs, the same fit
  mrpt::tfest::TSE2RobustResult result;
  if (!mrpt::tfest::se2_l2_robust(to_mrpt(pairs), deviation_m, parameters, result)) return fit;
  if (result.largestSubSet.size() < least || result.transformation.empty()) return fit;

  const auto& modes = result.transformation.getSOGModes();
  const auto best =
      std::ranges::max_element(modes, {}, [](const auto& mode) { return mode.log_w; });
  fit.transform = {{best->mean.x(), best->mean.y()}, wrap_angle(best->mean.phi())};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) fit.covariance(row, column) = best->cov(row, column);
  fit.agreeing = chosen(pairs, result.largestSubSet);
  fit.spread_m = spread_of(fit.agreeing);
  return fit;
}

}  // namespace galilean::monitor
