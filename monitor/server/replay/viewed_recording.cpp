// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/replay/viewed_recording.h"

#include <iterator>
#include <utility>

#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/record/copy_losses.h"
#include "monitor/record/damage_text.h"

namespace galilean::monitor {
namespace {

/// A recording of so many bytes is read whole in a second, so that all damage is known at once.
constexpr std::uint64_t kReadWhole_bytes = mcap::kCheckedBytes / 4;
constexpr std::size_t kMostTold = 100;

std::string shown_name(const ViewedRecording& recording) {
  return "'" + visible(recording.name) + "'";
}

}  // namespace

Result<ViewedRecording> ViewedRecording::open(const RecordingFolder& folder,
                                              const std::string& name) {
  auto opened = folder.open(name);
  if (!opened) return Error{opened.error().message};
  const auto& file = opened.value();
  auto summary =
      mcap::summarize(*file.source, file.bytes <= kReadWhole_bytes ? mcap::Depth::kAsNeeded
                                                                   : mcap::Depth::kIndexes);
  const auto shown = "'" + visible(name) + "' ";
  if (!summary) return Error{shown + summary.error().message + "."};
  if (summary.value().statistics.messages == 0)
    return Error{shown + "has no message that can be played."};
  auto topics = recorded_topics(summary.value());
  return ViewedRecording{name, file.source, std::move(summary).value(), std::move(topics)};
}

std::vector<std::string> DamageTeller::known() {
  const auto& summary = recording_.summary;
  std::vector<std::string> sentences;
  if (!summary.closed)
    sentences.push_back(shown_name(recording_) +
                        (summary.being_written
                             ? " is being written; what it has so far is played."
                             : " was not closed properly; what can be read of it is played."));
  for (const auto& copy : copy_losses(summary))
    sentences.push_back(shown_name(recording_) + " is a copy: " + copy_loss_text(copy) + ".");
  auto damages = newly(summary.damages);
  std::move(damages.begin(), damages.end(), std::back_inserter(sentences));
  if (const auto loss = loss_text(summary); !loss.empty())
    sentences.push_back(shown_name(recording_) + ": " + loss + ".");
  return sentences;
}

std::vector<std::string> DamageTeller::newly(const std::vector<mcap::Damage>& met) {
  std::vector<std::string> sentences;
  for (const auto& damage : met) {
    if (told_.size() > kMostTold || !told_.insert(damage.offset).second) continue;
    sentences.push_back(
        told_.size() > kMostTold
            ? shown_name(recording_) + " has more damage; 'galilean log info' lists all."
            : shown_name(recording_) + ": " + damage_text(damage, recording_.summary) + ".");
  }
  return sentences;
}

}  // namespace galilean::monitor
