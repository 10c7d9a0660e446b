// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/result.h"

namespace galilean::monitor {

/// What the monitor needs besides connections: DDS, the history, recordings, trials.
inline constexpr std::size_t kOwnDescriptors = 128;
/// With fewer, DDS may fail where it cannot say so.
inline constexpr std::size_t kFewestDescriptors = 256;
/// With more, nothing is won, and programs that are started inherit it.
inline constexpr std::size_t kMostDescriptors = 8192;

/// Raises this process's limit of file descriptors as far as the system lets it, to
/// kMostDescriptors at most. Returns the limit. Errors: it is below kFewestDescriptors.
[[nodiscard]] Result<std::size_t> raise_descriptor_limit();

/// A file descriptor that is kept open in reserve. Where no other is free, a connection can be
/// accepted with it and closed, so that its client does not wait for ever.
class ReserveDescriptor {
 public:
  ReserveDescriptor() { take(); }
  ~ReserveDescriptor() { give(); }
  ReserveDescriptor(const ReserveDescriptor&) = delete;
  ReserveDescriptor& operator=(const ReserveDescriptor&) = delete;

  /// Opens it, unless it is open or none is free.
  void take();
  /// Closes it, so that one is free. Returns whether it was open.
  bool give();

 private:
  int descriptor_ = -1;
};

}  // namespace galilean::monitor
