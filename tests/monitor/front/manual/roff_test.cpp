// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/manual/roff.h"

#include <gmock/gmock.h>

namespace galilean::front {
namespace {

using testing::HasSubstr;

TEST(Roff, BeginsWithTheTitleOfSectionOne) {
  EXPECT_THAT(Roff("galilean-sim", "Galilean 1.2.3").text(),
              HasSubstr("\n.TH GALILEAN\\-SIM 1 \"\" \"Galilean 1.2.3\" \"Galilean\"\n"));
}

TEST(Roff, ShowsCharactersThatItWouldObeyOrReplace) {
  EXPECT_EQ(Roff::plain(R"(a\b -c 'd' ^e ~f `g`)"), R"(a\eb \-c \(aqd\(aq \(hae \(tif \(gag\(ga)");
  EXPECT_EQ(Roff::plain("x … é 🤖"), "x \\[u2026] \\[u00E9] \\[u1F916]");
}

TEST(Roff, ALineThatBeginsWithAStopIsText) {
  Roff roff("page", "release");
  roff.paragraph(".bhdl is the ending of programs");
  roff.item(Roff::bold("'a"), "'b");
  EXPECT_THAT(roff.text(), HasSubstr(".PP\n\\&.bhdl is"));
  EXPECT_THAT(roff.text(), HasSubstr(".TP\n\\fB\\(aqa\\fR\n\\(aqb\n"));
}

}  // namespace
}  // namespace galilean::front
