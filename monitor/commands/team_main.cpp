// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/command_line/command_line.h"
#include "core/command_line/seconds_of.h"
#include "core/json_text.h"
#include "core/time_text.h"
#include "monitor/access/tokens.h"
#include "monitor/keys/team_keys.h"

namespace {

using namespace galilean::monitor;
using galilean::Result, galilean::Error, galilean::utc_text;

constexpr const char* kCommand = "galilean team keys";

struct Options {
  std::filesystem::path team = default_data_folder() / "team";
  std::string name;
  std::string role;
  double expires_after_s = 365.0 * 24 * 3600;
  bool as_json = false;
};

int fail(const std::string& why) {
  std::cerr << kCommand << ": " << why << '\n';
  return galilean::kFailed;
}

std::int64_t now_s() {
  return static_cast<std::int64_t>(std::time(nullptr));
}

int init(const Options& options) {
  if (const auto made = TeamKeys(options.team).init(); !made) return fail(made.error().message);
  std::cerr << "The team's two authorities are in " << options.team.string()
            << ". Keep that folder on one machine; members get a folder in members/ alone.\n";
  return EXIT_SUCCESS;
}

int tell_folder(const Result<std::filesystem::path>& folder, const std::string& name) {
  if (!folder) return fail(folder.error().message);
  std::cout << folder.value().string() << std::endl;
  std::cerr << "Copy that folder to where " << name
            << "'s programs run, and start them with --secure FOLDER.\n";
  return EXIT_SUCCESS;
}

int add(const Options& options) {
  const auto expires_s = now_s() + static_cast<std::int64_t>(options.expires_after_s);
  return tell_folder(
      TeamKeys(options.team).add(options.name, *member_role(options.role), expires_s),
      options.name);
}

int renew(const Options& options) {
  const auto expires_s = now_s() + static_cast<std::int64_t>(options.expires_after_s);
  return tell_folder(TeamKeys(options.team).renew(options.name, expires_s), options.name);
}

int revoke(const Options& options) {
  if (const auto done = TeamKeys(options.team).revoke(options.name); !done)
    return fail(done.error().message);
  std::cerr << options.name << " is revoked. Programs whose keys are in " << options.team.string()
            << " part with it within 10 s; copy revoked.crl from there into the folders of the "
               "others.\n";
  return EXIT_SUCCESS;
}

std::string_view state_of(const TeamMember& member) {
  if (member.revoked) return "revoked";
  return member.counts(now_s()) ? "valid" : "expired";
}

int print_json(const std::vector<TeamMember>& members) {
  auto items = nlohmann::json::array();
  for (const auto& member : members)
    items.push_back({{"name", member.name},
                     {"role", std::string(name_of(member.role))},
                     {"serial", member.serial},
                     {"expires", utc_text(member.expires_s)},
                     {"state", std::string(state_of(member))}});
  std::cout << galilean::json_text({{"certificates", std::move(items)}}, 1) << std::endl;
  return EXIT_SUCCESS;
}

int list(const Options& options) {
  const auto members = TeamKeys(options.team).list();
  if (!members) return fail(members.error().message);
  if (options.as_json) return print_json(members.value());
  for (const auto& member : members.value())
    std::cout << member.name << "  " << name_of(member.role) << "  " << state_of(member)
              << "  expires " << utc_text(member.expires_s) << '\n';
  if (members.value().empty())
    std::cerr << kCommand << ": the team in " << options.team.string() << " has no members\n";
  return EXIT_SUCCESS;
}

/// Reads how long keys are valid.
Result<void> read_validity(const std::string& text, double& target_s) {
  constexpr double kLongest_s = 10.0 * 365 * 24 * 3600;  // as long as their authorities
  const auto seconds = galilean::seconds_of(text);
  if (!seconds) return seconds.error();
  if (seconds.value() < 1 || seconds.value() > kLongest_s)
    return Error{"keys are valid for at least 1s and at most 10 years"};
  target_s = seconds.value();
  return {};
}

void add_expires(galilean::CommandLine& line, Options& options) {
  line.option(
          "--expires",
          [&options](const std::string& text) {
            return read_validity(text, options.expires_after_s);
          },
          "how long the keys are valid, such as 24h; a program that still runs then loses the "
          "team")
      .describe_default("a year");
}

std::vector<std::string> role_names() {
  std::vector<std::string> names;
  for (const auto role : kMemberRoles) names.emplace_back(name_of(role));
  return names;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  galilean::CommandLine app("Secures the team.", "galilean team");
  app.require_command();
  auto keys = app.command("keys", "make, list and revoke the keys of members, for DDS Security");
  keys.require_command();
  keys.share_options();
  keys.option("--team", options.team, "the folder of the team's keys").names_folder();
  auto initialising = keys.command("init", "make a team's two authorities");
  auto adding = keys.command("add", "make a member, in a folder to be copied to its machine");
  adding.option("name", options.name, "a robot's, or another program's or person's").required();
  adding.option("--role", options.role, "what the member may write and read")
      .one_of(role_names())
      .required();
  add_expires(adding, options);
  auto renewing = keys.command("renew", "give a member new keys of its role");
  renewing.option("name", options.name, "whose").required();
  add_expires(renewing, options);
  auto revoking = keys.command("revoke", "take a member out of the team");
  revoking.option("name", options.name, "whom").required();
  auto listing = keys.command("list", "list what was issued");
  listing.flag("--json", options.as_json, "as JSON");
  if (const auto code = app.parse(argc, argv)) return *code;
  if (initialising.chosen()) return init(options);
  if (adding.chosen()) return add(options);
  if (renewing.chosen()) return renew(options);
  if (revoking.chosen()) return revoke(options);
  return list(options);
}
