// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/keys/member_list.h"

#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "core/json_text.h"
#include "core/regular_file.h"
#include "core/visible_text.h"

namespace galilean::monitor {
namespace {

constexpr std::uintmax_t kMostListBytes = 4 << 20;
constexpr std::size_t kSerialDigits = 32;

Result<TeamMember> member_of(const nlohmann::json& item) try {
  TeamMember member{.name = item.at("name").get<std::string>(),
                    .role = MemberRole::kViewer,
                    .serial = item.at("serial").get<std::string>(),
                    .expires_s = item.at("expires_s").get<std::int64_t>(),
                    .revoked = item.at("revoked").get<bool>()};
  const auto role = member_role(item.at("role").get<std::string>());
  if (!role) return Error{"the role of '" + visible(member.name) + "' is none that there is"};
  if (member.serial.size() != kSerialDigits ||
      member.serial.find_first_not_of("0123456789abcdef") != std::string::npos)
    return Error{"the serial of '" + visible(member.name) + "' is not 32 hexadecimal digits"};
  member.role = *role;
  return member;
} catch (const nlohmann::json::exception& error) {
  return Error{error.what()};
}

Result<std::vector<TeamMember>> members_of(const nlohmann::json& document) {
  const auto found = document.is_object() ? document.find("certificates") : document.end();
  if (found == document.end() || !found->is_array())
    return Error{"it has no list \"certificates\""};
  std::vector<TeamMember> members;
  for (const auto& item : *found) {
    auto member = member_of(item);
    if (!member) return member.error();
    members.push_back(std::move(member).value());
  }
  return members;
}

}  // namespace

std::string member_list_text(const std::vector<TeamMember>& members) {
  auto items = nlohmann::json::array();
  for (const auto& member : members)
    items.push_back({{"name", member.name},
                     {"role", std::string(name_of(member.role))},
                     {"serial", member.serial},
                     {"expires_s", member.expires_s},
                     {"revoked", member.revoked}});
  return json_text({{"certificates", std::move(items)}}, 1) + "\n";
}

Result<std::string> read_member_file(const std::filesystem::path& file) {
  auto text = read_regular_file(file.string(), kMostListBytes);
  if (!text) return Error{file.string() + " cannot be read: " + text.error().message};
  return text;
}

Result<std::vector<TeamMember>> read_member_list(const std::filesystem::path& file) {
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown) && !unknown)
    return Error{file.string() +
                 " is not there; make a team's keys with 'galilean team keys init', or name their "
                 "folder with --team"};
  const auto text = read_member_file(file);
  if (!text) return text.error();
  const auto document = read_json(text.value());
  auto members =
      document ? members_of(document.value()) : Result<std::vector<TeamMember>>(document.error());
  if (!members)
    return Error{file.string() + " is damaged: " + members.error().message +
                 "; restore it, because without it nobody can be revoked"};
  return members;
}

}  // namespace galilean::monitor
