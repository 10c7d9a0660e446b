// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/recordings/recording_name.h"

#include <string>

#include "core/cut_text.h"
#include "core/visible_text.h"

namespace galilean::monitor {
namespace {

/// A file system takes 255 bytes; an upload's draft has some more behind its name.
constexpr std::size_t kLongestName = 200;

}  // namespace

bool is_listed_name(std::string_view name) {
  return !name.starts_with('.') && name.ends_with(kRecordingExtension);
}

Result<void> check_recording_name(std::string_view name) {
  const auto shown = "'" + visible(cut_text(name, kLongestName)) + "'";
  if (name.size() > kLongestName)
    return Error{"A recording's name has at most 200 bytes; " + shown + " begins a longer one."};
  if (name.find_first_of("/\\") != name.npos)
    return Error{"Only a name can be given here, and " + shown + " is a path."};
  if (visible(name) != name)
    return Error{"A recording's name has only characters that can be seen, and " + shown +
                 " has others; rename the file."};
  if (name.starts_with(' '))
    return Error{"A recording's name begins with no blank, as " + shown +
                 " does; rename the file."};
  if (!is_listed_name(name))
    return Error{"A recording's name is such as run.mcap, and not " + shown + "."};
  return {};
}

}  // namespace galilean::monitor
