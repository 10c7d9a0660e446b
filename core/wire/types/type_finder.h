// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "core/result.h"
#include "core/wire/participant.h"
#include "core/wire/types/type_description.h"

namespace galilean::wire {

/// Learns types of the domain from the processes that write or read them. For use by one thread.
class TypeFinder {
 public:
  /// Requires: the participant outlives this.
  explicit TypeFinder(const Participant& participant);

  /// Returns the type of that hash, which EndpointInfo tells. It asks the domain and blocks until
  /// all parts have come. It calls `give_up` every 50 ms, and ends if that returns true.
  /// Errors: a part did not come, or cannot be decoded. The error is a clause, as describe_type's.
  [[nodiscard]] Result<Type> find(const std::string& hash, const std::function<bool()>& give_up);

 private:
  std::int32_t participant_;
  std::map<std::string, Type> known_;
};

}  // namespace galilean::wire
