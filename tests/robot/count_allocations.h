// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::robot {

/// Counts what this thread allocates and releases, as long as it lives. One at a time.
class AllocationCount {
 public:
  AllocationCount();
  ~AllocationCount();
  AllocationCount(const AllocationCount&) = delete;
  AllocationCount& operator=(const AllocationCount&) = delete;
  [[nodiscard]] long so_far() const;
};

}  // namespace galilean::robot
