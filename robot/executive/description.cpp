// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/description.h"

namespace galilean::robot {

std::vector<std::string> kept_variables(const Description& from, const Description& to) {
  std::vector<std::string> kept;
  for (const auto& old_label : from.variables)
    for (const auto& new_label : to.variables) {
      const bool same = old_label.name == new_label.name && old_label.type == new_label.type;
      if (same && !(old_label.parameter && new_label.parameter)) kept.push_back(new_label.name);
    }
  return kept;
}

}  // namespace galilean::robot
