// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/recordings/recording_name.h"

#include <algorithm>
#include <string>

#include "core/visible_text.h"

namespace galilean::monitor {
namespace {

/// A file system takes 255 bytes; an upload's draft has some more behind its name.
constexpr std::size_t kLongestName = 200;

bool is_control(char letter) {
  return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
}

}  // namespace

Result<void> check_recording_name(std::string_view name) {
  const auto shown = "'" + visible(name.substr(0, kLongestName)) + "'";
  if (name.size() > kLongestName)
    return Error{"A recording's name has at most 200 bytes; " + shown + " begins a longer one."};
  if (name.find('/') != name.npos || std::ranges::any_of(name, is_control))
    return Error{"Only a name can be given here, and " + shown + " is none."};
  if (name.starts_with('.') || !name.ends_with(kRecordingExtension) ||
      name.size() == kRecordingExtension.size())
    return Error{"A recording's name is such as run.mcap, and not " + shown + "."};
  return {};
}

}  // namespace galilean::monitor
