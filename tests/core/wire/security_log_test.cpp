// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/security_log.h"

#include <gmock/gmock.h>

namespace galilean::wire {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(SecurityLog, SaysPlainlyWhyAndKeepsWhatCycloneSaid) {
  const std::string line =
      "Error occurred while validating local permission: Certificate not valid: error: certificate "
      "has expired; subject: CN=io(code: 200)";
  EXPECT_THAT(refusal_of(line), AllOf(HasSubstr("has expired; 'galilean team keys renew'"),
                                      HasSubstr("subject: CN=io")));
  EXPECT_THAT(refusal_of("Process handshake failed: Certificate not valid: error: unable to get "
                         "local issuer certificate; subject: CN=eve(code: 200)"),
              HasSubstr("not from this team's identity CA"));
  EXPECT_THAT(refusal_of("Validate remote identity failed: the member 80aa is revoked(code: 200)"),
              HasSubstr("the member is revoked;"));
  EXPECT_THAT(
      refusal_of("Failed to parse PKCS7 SMIME document: certificate verify error: unable to "
                 "get local issuer certificate(code: 124)"),
      HasSubstr("not signed by this team's permissions CA"));
  EXPECT_THAT(refusal_of("Error occurred while validating local permissions: Permissions validity "
                         "period has not started yet for CN=io (start: 2030-01-01T00:00:00Z)"),
              HasSubstr("check the machine's clock"));
  EXPECT_THAT(refusal_of("Error occurred while validating local permissions: Subject name is "
                         "invalid(code: 140)"),
              HasSubstr("for another member"));
  EXPECT_EQ(refusal_of("something new"), "something new");
}

TEST(SecurityLog, SaysOfAnotherTeamsProgramWhatItNeeds) {
  EXPECT_THAT(refusal_of("Validate remote identity failed: another identity CA vouches for the "
                         "certificate: CN=other; subject: CN=eve(code: 200)"),
              AllOf(HasSubstr("ask for keys of this team"), HasSubstr("subject: CN=eve")));
  EXPECT_THAT(refusal_of("handshake (lguid=1:2:3:1c1 rguid=4:5:6:1c1) failed: (4) Timed out"),
              HasSubstr("refuses the keys of this program"));
}

// Cyclone does not end such lines, so that what it logs next on that thread stands behind them.
TEST(SecurityLog, UnendedLinesOfUnsecuredProgramsAreCutOff) {
  const std::string writer = "Non secure remote writer 1:2:3:403 is not allowed.";
  const std::string reader = "Non secure remote reader 1:2:3:504 is not allowed.";
  const std::string next = "Process handshake failed: why(code: 200)";
  EXPECT_EQ(ended_part(writer), "");
  EXPECT_EQ(ended_part(writer + reader), "");
  EXPECT_EQ(ended_part(writer + reader + next), next);
  EXPECT_EQ(ended_part(writer + "Non secure remote rea(trunc)"), "");
  for (const auto& line : {std::string(), std::string("another"), next})
    EXPECT_EQ(ended_part(line), line);
}

TEST(SecurityLog, TheSameSentenceIsToldOnce) {
  testing::internal::CaptureStderr();
  for (int i = 0; i < 3; ++i) tell_once("'eve' (192.168.1.7) has no keys");
  tell_once("'adam' has no keys");
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "galilean: DDS Security: 'eve' (192.168.1.7) has no keys\n"
            "galilean: DDS Security: 'adam' has no keys\n");
}

}  // namespace
}  // namespace galilean::wire
