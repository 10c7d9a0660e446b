// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recording_report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "core/plural.h"

namespace galilean::monitor {

std::string recording_text(const std::string& name, const RecordingFiles::Totals& totals,
                           std::size_t topics) {
  std::array<char, 64> figures{};
  std::snprintf(figures.data(), figures.size(), "%.1f s, %.1f MB",
                static_cast<double>(totals.end_ns - totals.start_ns) * 1e-9,
                static_cast<double>(totals.bytes) * 1e-6);
  return name + ": " + plural(totals.messages, "message") + " of " + plural(topics, "topic") +
         " in " + figures.data();
}

std::string emptiness_text(Emptiness why) {
  switch (why) {
    case Emptiness::kNobodyHeard:
      return "no robot was heard; check that robots run, and in the same DDS domain (--domain or "
             "ROS_DOMAIN_ID)";
    case Emptiness::kAllLeftOut:
      return "nothing was recorded, because no topic on the wire matches --topics, or all that do "
             "match --exclude or carry pictures that --pictures leaves out; 'galilean list' shows "
             "the topics";
    case Emptiness::kAllSilent:
      break;
  }
  return "nothing was recorded, because none of those who write topics sent anything; 'galilean "
         "rate TOPIC' shows whether a topic is silent";
}

std::string losses_text(const WriterLosses& losses) {
  const auto lost = losses.lost.value_or(losses.overrun);
  const auto overrun = std::min(losses.overrun, lost);
  const std::array<std::pair<std::uint64_t, const char*>, 7> reasons{{
      {overrun, "lost because the recorder was too slow"},
      {lost - overrun, "lost before they reached the recorder"},
      {losses.unwritten, "not written for want of room"},
      {losses.paused, "sent while it was paused"},
      {losses.left_out, "left out as was asked"},
      {losses.sent_before, "sent before it listened"},
      {losses.filled, "recorded late, after a gap"},
  }};
  std::string text = losses.lost ? "" : "an unknown number lost";
  for (const auto& [count, reason] : reasons)
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + reason;
  return text;
}

std::vector<std::string> missing_text(const std::vector<WriterLosses>& losses) {
  std::vector<std::string> sentences;
  for (const auto& each : losses) {
    const auto lost = each.lost.value_or(0);
    const auto sent = each.recorded + lost + each.unwritten + each.left_out + each.paused;
    const std::string of = " of " + plural(sent, "message") + " of " + each.process;
    if (lost > 0)
      sentences.push_back(each.topic + " lost " + std::to_string(lost) + of +
                          (each.overrun > 0 ? ", " + std::to_string(each.overrun) +
                                                  " of them because the recorder was too slow"
                                            : ""));
    if (each.unwritten > 0)
      sentences.push_back(each.topic + " lacks, for want of room on the disk, " +
                          std::to_string(each.unwritten) + of);
  }
  return sentences;
}

}  // namespace galilean::monitor
