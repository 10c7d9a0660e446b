// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/wire/endpoints.h"
#include "monitor/record/topic_recording.h"

namespace galilean::monitor {

/// Notices writers that DDS does not connect with the reader that was made for them.
class MatchWatch {
 public:
  /// Looks at a writer that is there, once a second. Returns a sentence, once, if it has not been
  /// connected for some seconds. Requires: `recording` follows it.
  [[nodiscard]] std::optional<std::string> look(const wire::EndpointInfo& writer,
                                                const TopicRecording& recording);

 private:
  std::map<std::string, int> unheard_;  ///< looks, by the writer's GUID
};

}  // namespace galilean::monitor
