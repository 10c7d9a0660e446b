// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/log_info.h"

#include <gmock/gmock.h>

namespace galilean::monitor {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(LogInfo, ShowsTheCodesOfWhatATerminalWouldObey) {
  mcap::Summary summary;
  summary.header.library = "lib\x1b]0;title\a";
  summary.channels[1].topic = "/i\u200Bo/state\x1b[2J";
  summary.damages = {{.what = "chunk \x9b"}};
  const auto told = describe("run.mcap", summary, std::nullopt);
  EXPECT_THAT(told, HasSubstr("libU+001B]0;titleU+0007"));
  EXPECT_THAT(told, HasSubstr("/iU+200Bo/stateU+001B[2J"));
  EXPECT_THAT(told, HasSubstr("chunk 0x9B"));
  EXPECT_THAT(told, Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace galilean::monitor
