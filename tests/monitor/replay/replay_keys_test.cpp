// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "monitor/replay/replay_keys.h"

namespace galilean::monitor {
namespace {

using testing::ElementsAre;

TEST(ReplayKeys, AreThoseOfTheTerminalAndNoOthers) {
  EXPECT_THAT(keys_in(" .+-q"), ElementsAre(ReplayKey::kPause, ReplayKey::kStep, ReplayKey::kFaster,
                                            ReplayKey::kSlower, ReplayKey::kEnd));
  EXPECT_THAT(keys_in("\x1b[C\x1b[D\x1b[H"),
              ElementsAre(ReplayKey::kForward, ReplayKey::kBack, ReplayKey::kBegin));
  EXPECT_THAT(keys_in("xyz\x1b[A\x1b[1;5C\x1b\x1b["), ElementsAre());
  EXPECT_THAT(keys_in("\x1b[3~ "), ElementsAre(ReplayKey::kPause));
}

}  // namespace
}  // namespace galilean::monitor
