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
  EXPECT_EQ(refusal_of("something new"), "something new");
}

TEST(SecurityLog, AnUnsecuredStrangerIsOneHoweverManyTopicsItHas) {
  const auto writer = stranger_of("Non secure remote writer 1:2:3:403 is not allowed.");
  EXPECT_EQ(writer, stranger_of("Non secure remote reader 1:2:3:504 is not allowed."));
  EXPECT_NE(writer, stranger_of("Non secure remote writer 1:2:4:403 is not allowed."));
  for (const std::string line : {"", "Non secure remote ", "Non secure remote writer", "another"})
    EXPECT_EQ(stranger_of(line), line);
}

}  // namespace
}  // namespace galilean::wire
