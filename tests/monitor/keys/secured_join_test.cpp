// SPDX-License-Identifier: BSD-3-Clause
// What Cyclone says to keys: of one member a process, since a process has one grant.
#include <gmock/gmock.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "core/private_file.h"
#include "core/secure_folder.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "monitor/keys/authority.h"
#include "monitor/keys/team_keys.h"
#include "tests/free_domain.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const int kSecuredDomain = free_domain();

std::int64_t seconds_from_now(std::int64_t seconds) {
  return static_cast<std::int64_t>(std::time(nullptr)) + seconds;
}

class SecuredJoin : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(keys.init()); }
  void TearDown() override { unsetenv(kSecureVariable); }

  fs::path add(const std::string& name, MemberRole role, std::int64_t valid_s = 86400) const {
    const auto added = keys.add(name, role, seconds_from_now(valid_s));
    EXPECT_TRUE(added) << added.error().message;
    return keys.member_folder(name);
  }
  /// Why the program `name` may not join with these keys; empty if it may.
  static std::string refusal(const fs::path& folder, const std::string& name = "io") {
    setenv(kSecureVariable, folder.c_str(), 1);
    const auto joined = wire::Participant::join(name, kSecuredDomain);
    return joined ? std::string() : joined.error().message;
  }

  const TemporaryFolder folder;
  const TeamKeys keys{folder / "team"};
};

TEST_F(SecuredJoin, AMemberOfTheTeamJoins) {
  EXPECT_EQ(refusal(add("io", MemberRole::kRobot)), "");
}

TEST_F(SecuredJoin, InATeamsFolderAProgramTakesTheMemberOfItsName) {
  add("io", MemberRole::kRobot);
  EXPECT_EQ(refusal(folder / "team", "io"), "");
  EXPECT_THAT(refusal(folder / "team", "eve"), HasSubstr("has no member 'eve'"));
}

TEST_F(SecuredJoin, ADomainThatCannotBeSecuredIsRefused) {
  setenv(kSecureVariable, add("io", MemberRole::kRobot).c_str(), 1);
  const auto joined = wire::Participant::join("io", 231);
  ASSERT_FALSE(joined);
  EXPECT_THAT(joined.error().message, HasSubstr("DDS domain 231 cannot be secured"));
}

TEST_F(SecuredJoin, AFolderThatIsNotWholeIsRefused) {
  const auto io = add("io", MemberRole::kRobot);
  fs::remove(MemberFiles(io).revoked);
  EXPECT_THAT(refusal(io), HasSubstr("revoked.crl cannot be read"));
  EXPECT_THAT(refusal(folder / "none"), HasSubstr("cannot be read"));
}

TEST_F(SecuredJoin, WhatHasExpiredIsRefusedWithTheReason) {
  EXPECT_THAT(refusal(add("io", MemberRole::kRobot, -10)), HasSubstr("galilean team keys renew"));
}

TEST_F(SecuredJoin, WhoIsRevokedIsRefusedWithTheReason) {
  const auto io = add("io", MemberRole::kRobot);
  ASSERT_TRUE(keys.revoke("io"));
  EXPECT_THAT(refusal(io), HasSubstr("revoked"));
}

TEST_F(SecuredJoin, ACertificateOfAnotherTeamIsRefused) {
  const TeamKeys others(folder / "others");
  ASSERT_TRUE(others.init());
  ASSERT_TRUE(others.add("io", MemberRole::kRobot, seconds_from_now(86400)));
  const MemberFiles own(add("io", MemberRole::kRobot)), foreign(others.member_folder("io"));
  for (const auto& [from, to] :
       {std::pair(foreign.certificate, own.certificate), std::pair(foreign.key, own.key)})
    fs::copy_file(from, to, fs::copy_options::overwrite_existing);
  EXPECT_THAT(refusal(keys.member_folder("io")), HasSubstr("identity CA"));
}

TEST_F(SecuredJoin, AGrantThatAMemberSignedItselfIsRefused) {
  const auto eve = add("eve", MemberRole::kViewer);
  const MemberFiles files(eve);
  const auto self = Authority::read(files.certificate, files.key);
  ASSERT_TRUE(self);
  const auto grant = self.value().sign("<dds/>\n");
  ASSERT_TRUE(grant);
  ASSERT_TRUE(replace_private_file(files.grant, grant.value()));
  EXPECT_THAT(refusal(eve), HasSubstr("permissions CA"));
}

TEST_F(SecuredJoin, TheGrantOfAnotherMemberIsRefused) {
  const MemberFiles eve(add("eve", MemberRole::kViewer));
  const MemberFiles boss(add("boss", MemberRole::kMonitor));
  fs::copy_file(boss.grant, eve.grant, fs::copy_options::overwrite_existing);
  EXPECT_THAT(refusal(keys.member_folder("eve"), "eve"), HasSubstr("for another member"));
}

TEST_F(SecuredJoin, WhatTheRoleForbidsIsLeftOutAndTheProgramGoesOn) {
  const auto anna = add("anna", MemberRole::kViewer);
  setenv(kSecureVariable, anna.c_str(), 1);
  const auto joined = wire::Participant::join("anna", kSecuredDomain);
  ASSERT_TRUE(joined) << joined.error().message;
  wire::Participant& participant = *joined.value();
  wire::Writer<msg::RobotState> writer(participant, wire::robot_topic("io", "state"));
  EXPECT_FALSE(writer.write({}));
  EXPECT_EQ(writer.readers(), 0);
  wire::Reader orders(participant, wire::kCommandTopic, msg::Command::kRosType);
  orders.on_data([] {});
  orders.take([](const wire::Received&) { FAIL(); });
  EXPECT_EQ(orders.writers(), 0);
}

TEST_F(SecuredJoin, AProgramHearsItselfInASecuredTeam) {
  const auto own = add("monitor", MemberRole::kMonitor);
  setenv(kSecureVariable, own.c_str(), 1);
  const auto joined = wire::Participant::join("monitor", kSecuredDomain);
  ASSERT_TRUE(joined) << joined.error().message;
  wire::Reader reader(*joined.value(), wire::kCommandTopic, msg::Command::kRosType);
  wire::Writer<msg::Command> writer(*joined.value(), wire::kCommandTopic);
  ASSERT_TRUE(writer.write({}));
  int heard = 0;
  reader.take([&](const wire::Received&) { ++heard; });
  EXPECT_EQ(heard, 1);
}

}  // namespace
}  // namespace galilean::monitor
