// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace galilean::monitor {

/// Numbers the team's landmarks, so that no two have the same number.
class LandmarkIds {
 public:
  [[nodiscard]] std::uint64_t next() noexcept { return ++last_; }

 private:
  std::uint64_t last_ = 0;
};

}  // namespace galilean::monitor
