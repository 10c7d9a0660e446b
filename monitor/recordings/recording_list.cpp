// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/recordings/recording_list.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>

#include "core/visible_text.h"
#include "core/wire/ros_time.h"
#include "monitor/mcap/outline.h"
#include "monitor/playback/recorded_topics.h"

namespace galilean::monitor {
namespace {

constexpr std::uint64_t kRenewEach_ns = 10'000'000'000;

std::uint64_t wall_clock_now_ns() {
  return static_cast<std::uint64_t>(wire::wall_clock_ns());
}

std::string why_unreadable(const std::string& name, const Error& predicate) {
  return "'" + visible(name) + "' " + predicate.message + ".";
}

void fill(const mcap::Outline& outline, ListedRecording& to) {
  to.start_ns = outline.start_ns;
  to.end_ns = outline.end_ns;
  to.messages = outline.messages;
  to.robots = recorded_robots(outline.schemas, outline.channels);
  to.complete = outline.closed && !outline.being_written && !outline.damaged;
}

}  // namespace

Result<std::vector<ListedRecording>> RecordingList::list() {
  const auto names = folder_.names();
  if (!names) return names.error();
  std::map<std::string, Looked> now;
  std::vector<ListedRecording> listed;
  for (const auto& name : names.value()) {
    auto& looked = now[name] = look(name, std::move(looked_[name]));
    listed.push_back(looked.recording);
  }
  looked_ = std::move(now);
  std::ranges::stable_sort(listed, std::greater{}, &ListedRecording::modified_ns);
  read_some(listed);
  return listed;
}

/// Finds by reading which of the recordings that seem to be complete are damaged.
void RecordingList::read_some(std::vector<ListedRecording>& newest_first) {
  std::uint64_t room_bytes = kMostRead_bytes;
  for (auto& recording : newest_first) {
    if (!recording.complete || recording.bytes > room_bytes) continue;
    auto& looked = looked_[recording.name];
    if (std::exchange(looked.is_read, true)) continue;
    room_bytes -= recording.bytes;
    recording.complete = looked.recording.complete = is_whole(recording.name);
  }
}

bool RecordingList::is_whole(const std::string& name) const try {
  const auto opened = folder_.open(name);
  if (!opened) return false;
  const auto summary = mcap::summarize(*opened.value().source);
  return summary && !summary.value().recovered();
} catch (const std::exception&) {
  return false;
}

RecordingList::Looked RecordingList::look(const std::string& name, Looked before) const try {
  const auto opened = folder_.open(name);
  if (!opened) return {.recording = {.name = visible(name), .why = opened.error().message}};
  const auto& file = opened.value();
  Looked looked{.recording = {.name = name, .bytes = file.bytes, .modified_ns = file.modified_ns},
                .inode = file.inode};
  const auto& known = before.recording;
  const bool is_same = before.inode == file.inode && known.bytes == file.bytes &&
                       known.modified_ns == file.modified_ns;
  const bool is_fresh = before.inode == file.inode && wall_clock_now_ns() < before.renew_at_ns;
  if ((is_same && before.renew_at_ns == 0) || is_fresh) {
    before.recording.bytes = file.bytes;
    before.recording.modified_ns = file.modified_ns;
    return before;
  }
  const auto outline = mcap::outline(*file.source);
  if (!outline)
    looked.recording.why = why_unreadable(name, outline.error());
  else
    fill(outline.value(), looked.recording);
  if (outline && outline.value().being_written)
    looked.renew_at_ns = wall_clock_now_ns() + kRenewEach_ns;
  else if (outline)
    if (const auto right = mcap::check_content(*file.source, outline.value()); !right)
      looked.recording.why = why_unreadable(name, right.error());
  return looked;
} catch (const std::exception& problem) {
  // One file must not take the list of all others away.
  return {.recording = {.name = visible(name),
                        .why = "'" + visible(name) + "' cannot be read: " + problem.what() + "."}};
}

}  // namespace galilean::monitor
