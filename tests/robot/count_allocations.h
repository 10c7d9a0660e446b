// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::robot {

/// Counts what this thread allocates and releases while the object lives. Requires: no other object
/// of this class lives.
class AllocationCount {
 public:
  AllocationCount();
  ~AllocationCount();
  AllocationCount(const AllocationCount&) = delete;
  AllocationCount& operator=(const AllocationCount&) = delete;
  [[nodiscard]] long so_far() const;
};

}  // namespace galilean::robot
