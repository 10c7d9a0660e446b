// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "monitor/top/dashboard.h"
#include "tests/monitor/top/model/told.h"

namespace galilean::monitor::top {

using Said = std::vector<std::string>;

class FakePusher : public Pusher {
 public:
  [[nodiscard]] std::string hindrance() const override { return why_not; }
  void check(const PushWish& wish) override { wished = wish; }
  void push(bool with_canary) override { pushed = with_canary ? "with canary" : "to all"; }
  void push_at_once(const PushWish& wish) override {
    wished = wish;
    pushed = "at once";
  }
  void cancel() override { ++cancelled; }
  [[nodiscard]] PushReport report() const override { return told; }
  void list() override { ++listed; }
  [[nodiscard]] PastPushes pushes() const override { return past; }
  [[nodiscard]] std::optional<ToldLease> lease(const std::string& robot) const override {
    const auto found = leases.find(robot);
    if (found == leases.end()) return {};
    return found->second;
  }
  void change_lease(const std::string& deed, const std::string& robot,
                    const std::string& reason) override {
    changed.push_back(deed + " " + robot + (reason.empty() ? "" : ": " + reason));
  }
  [[nodiscard]] std::string take_lease_refusal() override {
    return std::exchange(lease_refusal, {});
  }

  std::string why_not;
  PushReport told;
  std::optional<PushWish> wished;
  std::string pushed;
  int cancelled = 0;
  PastPushes past;
  int listed = 0;
  std::map<std::string, ToldLease> leases;
  Said changed;
  std::string lease_refusal;
};

/// A dashboard of three robots that is steered by keys. What it says to robots is noted.
class Steered : public Told {
 protected:
  void SetUp() override {
    for (const char* name : {"callisto", "ganymede", "io"}) tell_of({.robot = name});
    dashboard.update();
  }
  void receive(const Message& message) override {
    Told::receive(message);
    history.note(message);
  }
  void press(std::string_view letters) {
    for (const char letter : letters) EXPECT_TRUE(dashboard.press({Key::kLetter, letter}));
  }
  void press(Key key) { EXPECT_TRUE(dashboard.press({key})); }
  std::string screen() { return dashboard.draw(80, 24).text(); }
  Voice voice() {
    return {[this](Operator::Word word, const std::vector<std::string>& robots) {
              return note(words_of(word), robots);
            },
            [this](const msg::BreakOrder& order) {
              std::string what = order.order;
              for (const auto& point : order.points)
                what += " " + point.from_state + ":" + point.to_state +
                        (order.order == "set"
                             ? " " + msg::name_of(msg::BreakPoint_Constants::kAll, point.kind)
                             : "");
              return note(what + " for", order.targets);
            }};
  }

  History history{clock};
  FakePusher pusher;
  Said said;
  Dashboard dashboard{{model, history, clock, voice(), pusher}, ""};

 private:
  /// Returns the order's id, which is its number.
  std::string note(std::string what, const std::vector<std::string>& robots) {
    for (const auto& robot : robots) what += " " + robot;
    said.push_back(what);
    return std::to_string(said.size());
  }
};

}  // namespace galilean::monitor::top
