// SPDX-License-Identifier: BSD-3-Clause
#include "core/refusal_words.h"

#include "core/plural.h"
#include "core/visible_text.h"

namespace galilean {

std::string refusal_words(std::string_view topic, std::uint64_t messages, std::string_view reason) {
  constexpr std::string_view kRoot = "rt";
  const std::string place =
      topic.starts_with("rt/") ? " on " + visible(topic.substr(kRoot.size())) : std::string();
  return plural(messages, "message") + place + agreeing(messages, " was", " were") +
         " not taken: " + visible(reason);
}

}  // namespace galilean
