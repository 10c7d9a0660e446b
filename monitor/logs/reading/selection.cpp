// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/reading/selection.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <limits>

#include "core/command_line/exit_code.h"
#include "core/visible_text.h"
#include "monitor/record/copy_losses.h"
#include "monitor/record/damage_text.h"
#include "monitor/replay/report.h"

namespace galilean::logs {
namespace {

/// Of more damages than so many, the rest is counted.
constexpr std::size_t kMostTold = 20;

std::string short_seconds(double time_s) {
  char text[48];
  std::snprintf(text, sizeof text, "%.6g s", time_s);
  return text;
}

}  // namespace

std::string part_text(const Selection& selection) {
  const auto& topics = selection.topics;
  std::string text;
  for (std::size_t i = 0; i < topics.size(); ++i)
    text += (i == 0 ? " of " : i + 1 == topics.size() ? " and " : ", ") + visible(topics[i]);
  if (selection.from_s > 0) text += " from " + short_seconds(selection.from_s) + " on";
  if (selection.to_s) text += " up to " + short_seconds(*selection.to_s);
  return text;
}

Result<SelectedMessages> SelectedMessages::of(const Recording& recording,
                                              const Selection& selection, std::size_t memory_bytes,
                                              ShowsProgress shows) {
  SelectedMessages made(recording, selection, memory_bytes);
  for (const auto& topic : selection.topics) {
    const auto ids = recording.channels_of(topic);
    if (!ids) return ids.error();
    made.channels_.insert(ids.value().begin(), ids.value().end());
  }
  if (shows != ShowsProgress::kNo)
    made.bar_ = progress_on_terminal("reading " + recording.path(),
                                     shows == ShowsProgress::kUnlessPrinting);
  return made;
}

SelectedMessages::SelectedMessages(const Recording& recording, const Selection& selection,
                                   std::size_t memory_bytes)
    : recording_(&recording),
      from_s_(selection.from_s),
      to_s_(selection.to_s.value_or(std::numeric_limits<double>::infinity())),
      all_topics_(selection.topics.empty()),
      reader_(std::make_unique<mcap::MessageReader>(recording.source(), recording.summary().blocks,
                                                    memory_bytes)) {}

const mcap::Message* SelectedMessages::next() {
  constexpr std::uint64_t kTellEach = 256;  // messages
  while (const mcap::Message* message = reader_->next()) {
    if (bar_ && read_++ % kTellEach == 0) bar_->show(reader_->progress());
    time_.move_to(message->log_ns);
    if (at_s() > to_s_) break;
    if (!is_wanted(*message)) continue;
    any_ = true;
    return message;
  }
  bar_.reset();
  return nullptr;
}

bool SelectedMessages::is_wanted(const mcap::Message& message) const {
  return at_s() >= from_s_ && takes_channel(message.channel_id);
}

std::optional<mcap::TimeRange> SelectedMessages::log_times(const Selection& selection) const {
  const bool from_start = selection.from_s <= 0,
             to_end = !selection.to_s || *selection.to_s > at_s();
  if ((from_start && to_end) || !time_.has_begun()) return std::nullopt;
  const auto log_ns = [&](double time_s) {
    const double position_ns = std::clamp(time_s, 0.0, at_s()) * 1e9;
    return time_.log_ns_at(std::min(static_cast<std::uint64_t>(position_ns), time_.position_ns()));
  };
  return mcap::TimeRange{
      from_start ? 0 : log_ns(selection.from_s),
      to_end ? std::numeric_limits<std::uint64_t>::max() : log_ns(*selection.to_s)};
}

std::vector<mcap::Damage> SelectedMessages::damages() const {
  auto all = recording_->summary().damages;
  std::ranges::move(monitor::newly_met(reader_->damages(), recording_->summary()),
                    std::back_inserter(all));
  return all;
}

std::string nothing_text(const Selection& selection, const SelectedMessages& read) {
  const std::string text = "there is no message" + part_text(selection);
  if (selection.from_s <= read.at_s()) return text;
  return text + "; " + read.recording().path() + " ends at " + short_seconds(read.at_s());
}

void tell_nothing(const std::string& program, const Selection& selection,
                  const SelectedMessages& read) {
  if (!read.any() && !part_text(selection).empty())
    std::cerr << program << ": " << nothing_text(selection, read) << '\n';
}

int tell_damage(const std::string& program, const SelectedMessages& read) {
  const auto& summary = read.recording().summary();
  const std::string who = program + ": " + read.recording().path();
  const auto damages = read.damages();
  for (std::size_t i = 0; i < std::min(damages.size(), kMostTold); ++i)
    std::cerr << who << ": damaged: " << monitor::damage_text(damages[i], summary) << '\n';
  if (damages.size() > kMostTold)
    std::cerr << who << ": " << damages.size() - kMostTold
              << " damages more; 'galilean log info --json' lists all\n";
  const bool unclosed = !summary.closed && !summary.being_written;
  if (unclosed) std::cerr << who << " was not closed properly; what it has was read\n";
  const auto copies = monitor::copy_losses(summary);
  for (const auto& copy : copies) std::cerr << who << ": " << monitor::copy_loss_text(copy) << '\n';
  return damages.empty() && !unclosed && copies.empty() ? 0 : kIncomplete;
}

}  // namespace galilean::logs
