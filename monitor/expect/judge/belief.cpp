// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/belief.h"

#include <algorithm>

namespace galilean::expect {

double KnownVariable::certainty_after(double seconds) const noexcept {
  if (!valid) return 0;
  return std::max(0.0, certainty - std::max(decay_per_s, 0.0) * std::max(seconds, 0.0));
}

void Belief::set_variables(std::int64_t at_ns, const msg::Variables& newest) {
  variables_ns = at_ns;
  for (const auto& item : newest.items) {
    const auto known = variables.find(item.name);
    if (known == variables.end()) continue;
    auto& variable = known->second;
    variable.type = item.type;
    variable.valid = item.valid;
    variable.certainty = static_cast<double>(item.certainty);
    variable.decay_per_s = static_cast<double>(item.decay_per_s);
    variable.values = item.values;
  }
}

}  // namespace galilean::expect
