// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/report.h"

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <sstream>

#include "core/plural.h"
#include "core/visible_text.h"
#include "monitor/record/copy_losses.h"
#include "monitor/record/damage_text.h"
#include "monitor/record/log_info.h"
#include "monitor/record/times.h"

namespace galilean::monitor {

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + visible(names[i]);
  return text;
}

std::string before_playing(const std::string& path, const mcap::Summary& summary,
                           const Tracks& tracks) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(1);
  out << condition_text(path, summary);
  for (const auto& copy : copy_losses(summary)) out << "lost: " << copy_loss_text(copy) << '\n';
  out << path << ": " << plural(topics_played(tracks), "topic") << ", " << duration_s(summary)
      << " s, from " << iso_time(summary.statistics.start_ns) << '\n';
  if (!tracks.commands.empty())
    out << "not played: " << listed(tracks.commands) << "; a replay gives robots no commands\n";
  if (tracks.has_other_clock) out << "not played: /clock; --clock tells the time instead\n";
  if (!tracks.foreign.empty())
    out << "not played: " << listed(tracks.foreign)
        << "; this release does not know their types, or defines them otherwise\n";
  return out.str();
}

std::string who_is_where(const std::set<std::string>& recorded, const std::set<std::string>& played,
                         const wire::Neighbours& there) {
  std::vector<std::string> left_out;
  std::ranges::set_difference(recorded, played, std::back_inserter(left_out));
  const auto line = [](const char* what, const std::vector<std::string>& names) {
    return what + (names.empty() ? "none" : listed(names)) + '\n';
  };
  return line("robots from the recording: ", {played.begin(), played.end()}) +
         (left_out.empty() ? "" : line("robots left out of it: ", left_out)) +
         line("live robots in this domain: ", there.live) +
         (there.played.empty() ? "" : line("robots of another replay: ", there.played));
}

std::string why_not_beside(const wire::Neighbours& namesakes) {
  const auto are = [](const std::vector<std::string>& names) {
    return listed(names) + agreeing(names.size(), " is", " are");
  };
  if (!namesakes.live.empty())
    return are(namesakes.live) +
           " live in this DDS domain, and a live robot and the recording would send under one "
           "name; end the live ones, play other robots (--robots), use another domain (--domain), "
           "or play all the same with --anyway";
  return are(namesakes.played) +
         " played by another replay in this DDS domain, and both would send under one name; end "
         "the other one, play other robots (--robots), use another domain (--domain), or play all "
         "the same with --anyway";
}

std::vector<mcap::Damage> newly_met(const std::vector<mcap::Damage>& met,
                                    const mcap::Summary& summary) {
  std::vector<mcap::Damage> fresh;
  std::ranges::copy_if(met, std::back_inserter(fresh), [&](const mcap::Damage& damage) {
    return std::ranges::find(summary.damages, damage.offset, &mcap::Damage::offset) ==
           summary.damages.end();
  });
  return fresh;
}

}  // namespace galilean::monitor
