// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/coverage_desk.h"

#include <utility>

#include "monitor/background/guarded.h"
#include "monitor/server/api/recording_coverage.h"
#include "monitor/server/api/recording_file.h"

namespace galilean::monitor {

void CoverageDesk::ask(const std::string& name, const Respond& respond) {
  auto& waiting = waiting_[name];
  waiting.push_back(respond);
  if (waiting.size() > 1) return;
  const bool is_taken = worker_.offer(
      [this, name] { return count(name); },
      [this, name](const HttpResponse& response) { tell(name, response); },
      [this, name](const std::string& why) {
        tell(name, problem(500, "The monitor failed to count the recording: " + why + "."));
      });
  if (!is_taken)
    tell(name, problem(503,
                       "More recordings wait to be counted than the monitor keeps; ask again in a "
                       "moment."));
}

HttpResponse CoverageDesk::count(const std::string& name) {
  const auto opened = folder_.open(name);
  if (!opened) return recording_problem(opened.error());
  const auto& file = opened.value();
  const bool is_same = newest_.name == name && newest_.bytes == file.bytes &&
                       newest_.modified_ns == file.modified_ns && newest_.inode == file.inode;
  if (is_same) return newest_.response;
  auto response = coverage_response(name, file, stops_);
  // The end of a recorder changes what is to be said, and may change nothing of the file.
  if (response.status == 200 && !file.source->is_being_written())
    newest_ = {name, file.bytes, file.modified_ns, file.inode, response};
  return response;
}

void CoverageDesk::tell(const std::string& name, const HttpResponse& response) {
  const auto waiting = waiting_.extract(name);
  if (waiting.empty()) return;
  for (const auto& respond : waiting.mapped())
    (void)guarded("an answer about " + name, [&] { respond(response); });
}

}  // namespace galilean::monitor
