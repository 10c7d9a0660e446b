// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/playback/seekable_player.h"

#include <algorithm>
#include <utility>

namespace galilean::monitor {
namespace {

/// Of the real clock: so late a message may be before the playback waits for it.
constexpr Duration kMostLate = std::chrono::milliseconds(100);
/// Nobody waits longer at once, so that times in the far future do no harm.
constexpr Duration kLongestWait = std::chrono::hours(1);
/// A hundred years, which a Duration can hold at any speed.
constexpr std::uint64_t kLongest_ns = std::uint64_t{100} * 366 * 24 * 3600 * 1'000'000'000;

}  // namespace

SeekablePlayer::SeekablePlayer(const mcap::ByteSource& source, const mcap::Summary& summary,
                               const std::vector<RecordedTopic>& topics, const Clock& real)
    : start_ns_(summary.statistics.start_ns),
      end_ns_(std::max(summary.statistics.end_ns, summary.statistics.start_ns)),
      silences_(summary.blocks),
      cursor_(source, summary.blocks, topics),
      clock_(real, 1) {
  cursor_.move_to(start_ns_);
}

Time SeekablePlayer::time_of(std::uint64_t log_ns) const noexcept {
  const auto since_ns = std::min(log_ns - std::min(log_ns, start_ns_), kLongest_ns);
  return Time{Duration(static_cast<Duration::rep>(since_ns))};
}

std::uint64_t SeekablePlayer::clock_ns() const noexcept {
  return start_ns_ + static_cast<std::uint64_t>(clock_.now().time_since_epoch().count());
}

std::uint64_t SeekablePlayer::now_ns() const noexcept {
  return std::min({clock_ns(), cursor_.read_until_ns(), end_ns_});
}

/// Returns the instant from which on nothing was taken yet.
std::uint64_t SeekablePlayer::resume_ns() {
  const auto now = now_ns();
  if (!taken_ns_ || now > *taken_ns_ || cursor_.goes_on_at(*taken_ns_)) return now;
  return *taken_ns_ + 1;
}

void SeekablePlayer::want(RecordingCursor::Channels channels) {
  const auto at_ns = resume_ns();
  cursor_.want(std::move(channels), at_ns);
}

void SeekablePlayer::pause(bool paused) {
  clock_.jump_to(time_of(now_ns()));
  paused_ = paused;
  clock_.pause(paused_ || ended_);
}

void SeekablePlayer::seek(std::uint64_t at_ns) {
  at_ns = std::clamp(at_ns, start_ns_, end_ns_);
  ended_ = false;
  taken_ns_.reset();
  cursor_.move_to(at_ns);
  clock_.jump_to(time_of(at_ns));
  clock_.pause(paused_);
}

const mcap::Message* SeekablePlayer::due() {
  const auto* message = cursor_.next();
  if (message && cursor_.next_is_past()) return message;
  if (paused_ || ended_) return nullptr;
  if (!message) {
    if (cursor_.is_at_end()) end_if_over();
    return nullptr;
  }
  keep_time_with(*message);
  return time_of(message->log_ns) <= clock_.now() ? message : nullptr;
}

/// Requires: the message is not past.
bool SeekablePlayer::is_behind_silence(const mcap::Message& next) const {
  return silences_.between(cursor_.read_before_ns(), next.log_ns);
}

/// Moves the clock on to a message behind a silence, and back to one that is late.
void SeekablePlayer::keep_time_with(const mcap::Message& next) {
  const auto due = time_of(next.log_ns);
  const double late_s = to_seconds(clock_.now() - due) / clock_.rate();
  const bool is_silent = is_behind_silence(next) && clock_ns() >= cursor_.read_before_ns();
  if (late_s > to_seconds(kMostLate) || (late_s < 0 && is_silent)) clock_.jump_to(due);
}

void SeekablePlayer::end_if_over() {
  if (const auto next_ns = silences_.end_of_silence_at(clock_ns()))
    clock_.jump_to(time_of(std::min(*next_ns, end_ns_)));
  if (clock_.now() < time_of(end_ns_)) return;
  ended_ = true;
  clock_.jump_to(time_of(end_ns_));
  clock_.pause(true);
}

void SeekablePlayer::take() {
  if (const auto* message = cursor_.next(); message && !cursor_.next_is_past())
    taken_ns_ = message->log_ns;
  cursor_.take();
}

std::optional<Duration> SeekablePlayer::until_next() {
  const auto* message = cursor_.next();
  if (message && cursor_.next_is_past()) return Duration{};
  if (paused_ || ended_) return std::nullopt;
  if (!message && !cursor_.is_at_end()) return Duration{};
  const auto next_ns = !message                      ? end_ns_
                       : is_behind_silence(*message) ? cursor_.read_before_ns()
                                                     : message->log_ns;
  const Time soon = clock_.now() + kLongestWait;
  return clock_.real_until(std::min(time_of(next_ns), soon));
}

SeekablePlayer::Status SeekablePlayer::status() const noexcept {
  if (ended_) return Status::kEnded;
  return paused_ ? Status::kPaused : Status::kPlaying;
}

}  // namespace galilean::monitor
