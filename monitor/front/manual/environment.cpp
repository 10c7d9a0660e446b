// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/manual/environment.h"

#include <algorithm>
#include <array>
#include <string>

namespace galilean::front {
namespace {

constexpr std::array kVariables{
    EnvironmentVariable{"ROS_DOMAIN_ID",
                        "The DDS domain, from 0 to 232, where --domain does not name one. "
                        "Without both it is 0.",
                        "--domain", ""},
    EnvironmentVariable{"GALILEAN_PEERS",
                        "Addresses of other machines of the team, with commas between them. They "
                        "are found even where the network carries no multicast.",
                        "--domain", ""},
    EnvironmentVariable{"GALILEAN_SECURE",
                        "The folder of this member's keys, for DDS Security, where --secure does "
                        "not name one; or the team's folder, in which each program takes the "
                        "member of its own name. Without both, messages are neither encrypted nor "
                        "signed.",
                        "--secure", ""},
    EnvironmentVariable{"GALILEAN_TRUST",
                        "The file of the keys whose orders move a robot, where --trust does not "
                        "name one. Without both it is /etc/galilean/team.keys, if that is there.",
                        "--trust", ""},
    EnvironmentVariable{"CYCLONEDDS_URI", "Settings of Cyclone DDS, in addition to Galilean's.",
                        "--domain", ""},
    EnvironmentVariable{"XDG_STATE_HOME",
                        "The folder in which the folder galilean keeps the monitor's tokens, the "
                        "operator's key and the history of pushes, what robots need for a start "
                        "after a crash, and how often simulated boards were started. Without it "
                        "that is ~/.local/state.",
                        "--data,--token-file,--monitor,--live,--key", "demo,robot"},
    EnvironmentVariable{"HOME", "Your own folder, which ~ stands for.",
                        "--data,--token-file,--monitor,--live,--key", "demo,robot"},
    EnvironmentVariable{"USER",
                        "The author of pushes and orders, as others see it. Without it that is the "
                        "account's name.",
                        "--author",
                        "top,sim ctl,start,stop,hold,resume,record,record pause,record resume"},
    EnvironmentVariable{"XDG_RUNTIME_DIR",
                        "The folder of a live simulation's serial lines, if it can be written. "
                        "Otherwise they are in the folder for temporary files.",
                        "--live", "demo"},
    EnvironmentVariable{"TERM", "The terminal's type, which tells how many colours it has.", "",
                        "top"},
    EnvironmentVariable{"COLORTERM", "truecolor or 24bit if the terminal shows all colours.", "",
                        "top"},
    EnvironmentVariable{"NO_COLOR", "If it is not empty, no colours are used.", "", "top"},
    EnvironmentVariable{"LC_ALL",
                        "The locale. The first that is set of LC_ALL, LC_CTYPE and LANG counts. "
                        "If it does not name UTF-8, ASCII is drawn.",
                        "", "top"},
    EnvironmentVariable{"LC_CTYPE", "See LC_ALL.", "", "top"},
    EnvironmentVariable{"LANG", "See LC_ALL.", "", "top"},
};

/// Returns whether `word` is in `list`, whose words have commas between them.
bool is_listed(std::string_view word, std::string_view list) {
  const std::string between = "," + std::string(list) + ",";
  return between.find("," + std::string(word) + ",") != between.npos;
}

bool has_option_in(std::string_view list, const CommandDescription& command) {
  const auto is_wanted = [&](const OptionDescription& option) {
    return std::ranges::any_of(option.names,
                               [&](const auto& name) { return is_listed(name, list); });
  };
  return std::ranges::any_of(command.options, is_wanted) ||
         std::ranges::any_of(command.commands,
                             [&](const auto& inner) { return has_option_in(list, inner); });
}

}  // namespace

std::span<const EnvironmentVariable> environment_variables() noexcept {
  return kVariables;
}

std::vector<EnvironmentVariable> environment_of(const DescribedVerb& verb) {
  std::vector<EnvironmentVariable> read;
  for (const auto& variable : kVariables)
    if (is_listed(verb.name, variable.verbs) || has_option_in(variable.options, verb.command))
      read.push_back(variable);
  return read;
}

}  // namespace galilean::front
