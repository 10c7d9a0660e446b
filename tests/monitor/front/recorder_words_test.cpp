// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/recorder_words.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/temporary_folder.h"

namespace galilean::front {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(RecorderWords, AreToldOnceEachWhenTheirLineIsWhole) {
  const TemporaryFolder folder;
  RecorderWords words(folder / "record.log");
  EXPECT_THAT(words.take(), IsEmpty()) << "there is no log yet";
  std::ofstream log(folder / "record.log");
  log << "galilean-record: one\nrun.mcap: 3 messages\ngalilean-record: tw" << std::flush;
  EXPECT_THAT(words.take(), ElementsAre("one"));
  EXPECT_THAT(words.take(), IsEmpty());
  log << "o\n" << std::flush;
  EXPECT_THAT(words.take(), ElementsAre("two"));
}

}  // namespace
}  // namespace galilean::front
