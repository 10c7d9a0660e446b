// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::robot {

/// Counts how often this thread allocates and releases memory while the count lives. There may be
/// only one at a time.
class AllocationCount {
 public:
  AllocationCount();
  ~AllocationCount();
  AllocationCount(const AllocationCount&) = delete;
  AllocationCount& operator=(const AllocationCount&) = delete;
  [[nodiscard]] long so_far() const;
};

}  // namespace galilean::robot
