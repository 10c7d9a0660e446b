// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/report.h"

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <sstream>

#include "core/plural.h"
#include "core/visible_text.h"
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
