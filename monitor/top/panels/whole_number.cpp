// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/panels/whole_number.h"

#include <cmath>

namespace galilean::monitor::top {

int whole_number(double number, int least, int most) noexcept {
  if (!(number > least)) return least;
  return number < most ? static_cast<int>(std::lround(number)) : most;
}

}  // namespace galilean::monitor::top
