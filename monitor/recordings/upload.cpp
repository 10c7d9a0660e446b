// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/recordings/upload.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <system_error>
#include <utility>

#include "core/plural.h"
#include "core/private_file.h"
#include "core/visible_text.h"
#include "monitor/mcap/mcap_records.h"
#include "monitor/mcap/outline.h"
#include "monitor/record/disk_room.h"
#include "monitor/recordings/recording_name.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using Why = NotKept::Why;

constexpr std::uint64_t kLookEach_bytes = std::uint64_t{16} << 20;
constexpr std::string_view kDraftExtension = ".part";

fs::path draft_of(const RecordingFolder& folder, const std::string& name) {
  static std::atomic<unsigned> uploads = 0;
  return folder.path() / ("." + name + "." + std::to_string(getpid()) + "-" +
                          std::to_string(++uploads) + std::string(kDraftExtension));
}

std::string shown(const std::string& name) {
  return "'" + visible(name) + "'";
}

NotKept exists(const std::string& name) {
  return {Why::kExists, "There is a recording " + shown(name) + " already; choose another name."};
}

NotKept unwritable(const std::string& name, const std::string& reason) {
  return {Why::kUnwritable, shown(name) + " cannot be kept: " + reason + "."};
}

NotKept unwritten(const std::string& name, int reason, const Error& error) {
  if (reason == ENOSPC || reason == EDQUOT)
    return {Why::kNoRoom, "The disk is full: nothing of " + shown(name) +
                              " was kept; make room, then send it again."};
  return unwritable(name, error.message);
}

NotKept no_recording(const std::string& name,
                     const std::string& predicate = "is not an MCAP file") {
  return {Why::kNoRecording, shown(name) + " " + predicate + "."};
}

KeptRecording kept(const std::string& name, const mcap::Summary& summary) {
  if (summary.closed && summary.damages.empty()) return {.complete = true, .note = {}};
  return {.complete = false,
          .note = shown(name) +
                  " was kept, but is not whole: " + plural(summary.statistics.messages, "message") +
                  " of it can be read, and 'galilean log recover' writes them to a whole file."};
}

NotKept too_large(std::uint64_t most_bytes) {
  return {Why::kTooLarge, "A recording may have " + std::to_string(most_bytes / 1'000'000) +
                              " MB at most here; copy larger ones into the folder."};
}

NotKept no_room(std::uint64_t least_bytes) {
  return {Why::kNoRoom, "The disk has no room for it: " + std::to_string(least_bytes / 1'000'000) +
                            " MB must stay free."};
}

/// Gives the draft its name, unless that is taken. Returns 0, or the system's reason.
int rename_new(const fs::path& draft, const fs::path& target) {
  if (renameat2(AT_FDCWD, draft.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  // Some file systems do not know RENAME_NOREPLACE. A link fails as well where the name is taken.
  if (link(draft.c_str(), target.c_str()) != 0) return errno;
  unlink(draft.c_str());
  return 0;
}

}  // namespace

Result<Upload, NotKept> Upload::begin(const RecordingFolder& folder, const std::string& name,
                                      std::optional<std::uint64_t> bytes, const Limits& limits) {
  if (const auto right = check_recording_name(name); !right)
    return NotKept{Why::kNoName, right.error().message};
  std::error_code failed;
  (void)make_private_folder(folder.path());  // what fails is said when the draft is made
  const auto target = folder.path() / name;
  if (fs::symlink_status(target, failed).type() != fs::file_type::not_found) return exists(name);
  if (bytes.value_or(0) > limits.most_bytes) return too_large(limits.most_bytes);
  const auto free = free_bytes(target.string());
  if (free && *free < limits.least_free_bytes + bytes.value_or(0))
    return no_room(limits.least_free_bytes);
  auto draft = draft_of(folder, name);
  errno = 0;
  auto sink = mcap::FileSink::create(draft.string(), false);
  if (!sink) return unwritten(name, errno, sink.error());
  return Upload(std::move(draft), target, name, std::move(sink).value(), limits);
}

Upload::Upload(fs::path draft, fs::path target, std::string name, mcap::FileSink sink,
               const Limits& limits)
    : draft_(std::move(draft)),
      target_(std::move(target)),
      name_(std::move(name)),
      sink_(std::make_unique<mcap::FileSink>(std::move(sink))),
      limits_(limits) {}

Upload::~Upload() {
  if (sink_) unlink(draft_.c_str());
}

Upload::Kept Upload::append(std::span<const std::uint8_t> piece) {
  const auto missing = sizeof mcap::kMagic - begin_.size();
  std::ranges::copy(piece.first(std::min(missing, piece.size())), std::back_inserter(begin_));
  if (!std::ranges::equal(begin_, std::span(mcap::kMagic).first(begin_.size())))
    return no_recording(name_);
  written_ += piece.size();
  if (written_ > limits_.most_bytes) return too_large(limits_.most_bytes);
  if (const auto room = look_for_room(); !room) return room;
  errno = 0;
  if (const auto done = sink_->write(piece); !done) return unwritten(name_, errno, done.error());
  return {};
}

Upload::Kept Upload::look_for_room() {
  if (written_ < looked_at_ + kLookEach_bytes) return {};
  looked_at_ = written_;
  const auto free = free_bytes(draft_.string());
  if (free && *free < limits_.least_free_bytes) return no_room(limits_.least_free_bytes);
  return {};
}

Result<KeptRecording, NotKept> Upload::look_into() const {
  const auto draft = mcap::FileSource::open(draft_.string());
  if (!draft) return unwritable(name_, draft.error().message);
  if (const auto right = mcap::check_header(draft.value()); !right)
    return no_recording(name_, right.error().message);
  const auto outline = mcap::outline(draft.value());
  if (!outline) return no_recording(name_, outline.error().message);
  if (const auto right = mcap::check_content(draft.value(), outline.value()); !right)
    return no_recording(name_, right.error().message);
  const auto summary = mcap::summarize(draft.value());
  if (!summary) return no_recording(name_, summary.error().message);
  return kept(name_, summary.value());
}

Result<KeptRecording, NotKept> Upload::finish() {
  if (begin_.size() < sizeof mcap::kMagic) return no_recording(name_);
  auto looked = look_into();
  if (!looked) return looked;
  errno = 0;
  if (const auto done = sink_->sync(); !done) return unwritten(name_, errno, done.error());
  const int reason = rename_new(draft_, target_);
  if (reason == EEXIST) return exists(name_);
  if (reason != 0) return unwritable(name_, std::strerror(reason));
  sink_.reset();
  return looked;
}

void remove_abandoned_uploads(const RecordingFolder& folder) {
  std::error_code failed;
  for (fs::directory_iterator at(folder.path(), failed), end; !failed && at != end;
       at.increment(failed)) {
    const auto name = at->path().filename().string();
    const auto end_of_name = std::string(kRecordingExtension) + ".";
    if (!name.starts_with('.') || !name.ends_with(kDraftExtension) ||
        name.find(end_of_name) == name.npos || !at->is_regular_file(failed))
      continue;
    // A draft on which somebody works is locked.
    const auto draft = mcap::FileSource::open(at->path().string());
    if (draft && !draft.value().is_being_written()) unlink(at->path().c_str());
  }
}

}  // namespace galilean::monitor
