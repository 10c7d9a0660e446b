// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/authentication/identity_token.h"

#include <gtest/gtest.h>

#include <array>

namespace galilean::wire {
namespace {

TEST(IdentityToken, TellsWhoIsSaidToVouchForWhom) {
  std::array<char, 16> subject{"/CN=io"}, authority{"/CN=ours"}, subject_name{"dds.cert.sn"},
      authority_name{"dds.ca.sn"};
  std::array<DDS_Security_Property_t, 3> properties{};
  properties[1].name = subject_name.data();
  properties[1].value = subject.data();
  properties[2].name = authority_name.data();
  properties[2].value = authority.data();
  DDS_Security_IdentityToken token{};
  EXPECT_EQ(authority_in(token), "") << "it has no properties";
  token.properties._buffer = properties.data();
  token.properties._length = 3;
  EXPECT_EQ(authority_in(token), "/CN=ours");
  EXPECT_EQ(subject_in(token), "/CN=io");
  properties[2].value = nullptr;
  EXPECT_EQ(authority_in(token), "");
}

}  // namespace
}  // namespace galilean::wire
