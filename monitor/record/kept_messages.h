// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/wire/endpoints.h"
#include "core/wire/reader.h"

namespace galilean::monitor {

/// Keeps what writers of states keep for late joiners: their newest message. Each file of a
/// recording begins with it, so that it can be read without the files before it.
class KeptMessages {
 public:
  struct Kept {
    wire::EndpointInfo writer;
    std::uint64_t sequence = 0;
    std::int64_t sent_ns = 0;
    std::vector<std::uint8_t> cdr;
  };

  /// Takes note of a message, if its writer keeps one for late joiners.
  void note(const wire::EndpointInfo& writer, const wire::Received& received);
  /// Forgets what those writers kept that are not among `present`.
  void forget_all_but(const std::vector<wire::EndpointInfo>& present);
  /// Returns what is kept, by the GUIDs of the writers.
  [[nodiscard]] const std::map<std::string, Kept>& all() const noexcept { return kept_; }

 private:
  std::map<std::string, Kept> kept_;
};

}  // namespace galilean::monitor
