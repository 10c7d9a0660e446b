// SPDX-License-Identifier: BSD-3-Clause
#include "robot/watch/links.h"

#include <deque>
#include <system_error>

namespace galilean::robot {

namespace fs = std::filesystem;

FollowedPath follow_links(const fs::path& path) {
  constexpr std::size_t kMostLinks = 40;  // as many as Linux follows
  std::error_code unknown;
  const fs::path whole = fs::absolute(path, unknown);
  FollowedPath followed{.links = {}, .file = whole.root_path()};
  const fs::path relative = whole.relative_path();
  std::deque<fs::path> rest(relative.begin(), relative.end());
  while (!rest.empty()) {
    const fs::path part = rest.front();
    rest.pop_front();
    if (part.empty() || part == ".") continue;
    const fs::path next = part == ".." ? followed.file.parent_path() : followed.file / part;
    std::error_code no_link;
    const fs::path target = fs::read_symlink(next, no_link);
    if (part == ".." || no_link || followed.links.size() == kMostLinks) {
      followed.file = next;
      continue;
    }
    followed.links.push_back(next);
    if (target.is_absolute()) followed.file = target.root_path();
    const fs::path steps = target.relative_path();
    rest.insert(rest.begin(), steps.begin(), steps.end());
  }
  return followed;
}

}  // namespace galilean::robot
