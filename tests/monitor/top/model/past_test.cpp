// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/past.h"

#include <gtest/gtest.h>

#include "core/wire/messages.h"
#include "tests/monitor/top/model/told.h"

namespace galilean::monitor::top {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class Remembered : public Told {
 protected:
  void receive(const Message& message) override {
    Told::receive(message);
    history.note(message);
  }

  History history{clock};
  Curves curves{history};
};

TEST_F(Remembered, ThePastShowsWhatWasKnownThen) {
  tell_of_map(1);
  clock.advance(seconds(10));
  tell_of_map(2);
  clock.advance(seconds(10));
  const Past then(history, Time{seconds(9)});
  EXPECT_EQ(to_seconds(then.clock().now() - Time{}), 9);
  EXPECT_EQ(then.model().objects(), nullptr);  // nothing came for nine seconds
  const Past sooner(history, Time{seconds(1)});
  ASSERT_NE(sooner.model().objects(), nullptr);
  EXPECT_EQ(sooner.model().objects()->objects[0].x_m, 1);
  const Past later(history, Time{seconds(12)});
  EXPECT_EQ(later.model().objects()->objects[0].x_m, 2);
}

TEST_F(Remembered, StatesAreKeptTwiceASecondAndForSomeMinutes) {
  for (int i = 0; i < 100; ++i, clock.advance(milliseconds(100))) tell_of_io();
  EXPECT_EQ(history.until("rt/io/variables", clock.now(), 1000).size(), 20u);
  EXPECT_EQ(history.until("rt/io/variables", Time{seconds(2)}, 1000).size(), 5u);
  EXPECT_EQ(history.until("rt/io/variables", clock.now(), 3).size(), 3u);
  clock.advance(History::kKept + seconds(60));
  tell_of_io();
  EXPECT_EQ(history.until("rt/io/variables", clock.now(), 1000).size(), 1u);
  EXPECT_EQ(history.begin(), clock.now());
}

TEST_F(Remembered, ThePastSaysThatNobodyReadWhatARobotSaw) {
  tell_of_io();
  const Past then(history, clock.now());
  const View view =
      make_view({then.model(), then.clock(), model.identities(), &curves, nullptr, &clock}, {});
  EXPECT_EQ(view.map_title, "io's own frame (no monitor; what it saw then was not read)");
}

TEST_F(Remembered, AVariablesCurveIsMadeOfItsPast) {
  for (int i = 0; i < 6; ++i, clock.advance(History::kEach)) tell_of_io(i);
  const View view = make_view({model, clock, model.identities(), &curves}, {.robot = "io"});
  ASSERT_EQ(view.variables.size(), 1u);
  EXPECT_EQ(view.variables[0].recent, (std::vector<double>{0, 1, 2, 3, 4, 5}));
}

}  // namespace
}  // namespace galilean::monitor::top
