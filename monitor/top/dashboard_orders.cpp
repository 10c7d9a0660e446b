// SPDX-License-Identifier: BSD-3-Clause
#include <cctype>
#include <utility>

#include "monitor/top/dashboard.h"

namespace galilean::monitor::top {
namespace {

constexpr Duration kTellAgainEach = std::chrono::seconds(1);
constexpr Duration kAllStoppedShown = std::chrono::seconds(5);

std::string words(Operator::Word word) {
  switch (word) {
    case Operator::Word::kHold:
      return "hold";
    case Operator::Word::kResume:
      return "resume";
    case Operator::Word::kStep:
      return "step";
    case Operator::Word::kDecommission:
      return "decommission";
    case Operator::Word::kCommission:
      return "commission";
    case Operator::Word::kStart:
      break;
  }
  return "start";
}

std::vector<std::string> names_of(const std::vector<Unconfirmed>& robots) {
  std::vector<std::string> names;
  for (const auto& each : robots) names.push_back(each.robot);
  return names;
}

}  // namespace

void Dashboard::tell(std::string notice) {
  notice_ = std::move(notice);
  noticed_ = parts_.clock.now();
}

void Dashboard::update() {
  const Time now = parts_.clock.now();
  const Team& team = parts_.model.team();
  board_.update(finder_.find(parts_.model, now), now);
  settle(now);
  if (!stop_order_) return;
  stop_order_->update(team);
  const auto progress = stop_order_->progress(team, now);
  if (!progress.unconfirmed.empty()) all_stopped_.reset();
  if (progress.unconfirmed.empty() && !all_stopped_) all_stopped_ = now;
  if (all_stopped_ && now - *all_stopped_ > kAllStoppedShown) return stop_order_.reset();
  if (progress.unconfirmed.empty() || now - stop_told_ < kTellAgainEach) return;
  stop_told_ = now;
  static_cast<void>(parts_.say(Operator::Word::kHold, names_of(progress.unconfirmed)));
}

void Dashboard::settle(Time now) {
  constexpr Duration kAllAreHeard = std::chrono::seconds(2);
  const auto& robots = parts_.model.team().robots();
  if (is_settled_ || robots.empty()) return;
  choice_.robot = robots.begin()->first;
  if (!first_heard_) first_heard_ = now;
  is_settled_ = now - *first_heard_ >= kAllAreHeard;
}

void Dashboard::stop_all() {
  const bool sent = parts_.say(Operator::Word::kHold, {});
  stop_told_ = parts_.clock.now();
  stop_order_.emplace(stop_told_);
  all_stopped_.reset();
  tell(sent ? "told all robots to stop; Esc ends the report"
            : "DDS did not take the order to stop; it is sent again every second");
}

std::string Dashboard::shown_robot() const {
  const View shown = view();
  return shown.robots.empty() ? std::string() : shown.robots[shown.chosen].status.name;
}

void Dashboard::say(Operator::Word word, const std::string& robot, bool to_all) {
  if (robot.empty()) return tell("No robot is heard that could be told.");
  if (word == Operator::Word::kResume) end_stop_of(robot, to_all);
  const bool sent =
      parts_.say(word, to_all ? std::vector<std::string>{} : std::vector<std::string>{robot});
  tell((sent ? "told " : "could not tell ") + (to_all ? "all robots" : robot) + " to " +
       words(word));
}

void Dashboard::end_stop_of(const std::string& robot, bool of_all) {
  if (!stop_order_) return;
  stop_order_->release(robot);
  const auto rest = stop_order_->progress(parts_.model.team(), parts_.clock.now());
  if (of_all || (rest.stopped.empty() && rest.unconfirmed.empty())) stop_order_.reset();
}

void Dashboard::ask(std::string question, std::function<void()> yes) {
  question_ = std::move(question);
  yes_ = std::move(yes);
  mode_ = Mode::kQuestion;
}

void Dashboard::answer(char letter) {
  mode_ = Mode::kTeam;
  const auto yes = std::exchange(yes_, nullptr);
  if (letter == 'y' || letter == 'Y') yes();
}

bool Dashboard::press_letter(char letter) {
  // What is asked about is what is told later, whatever is chosen by then.
  const std::string robot = shown_robot();
  if (letter >= '1' && letter <= '9') choose(static_cast<std::size_t>(letter - '1'));
  const bool to_all = std::isupper(static_cast<unsigned char>(letter));
  switch (std::tolower(static_cast<unsigned char>(letter))) {
    case 'h':
      say(Operator::Word::kHold, robot, to_all);
      break;
    case 'r':
      if (robot.empty()) break;
      ask("Resume " + (to_all ? "all robots" : robot) + "?",
          [this, robot, to_all] { say(Operator::Word::kResume, robot, to_all); });
      break;
    case 's':
      say(Operator::Word::kStart, robot, to_all);
      break;
    case 'a':
      to_all ? acknowledge_shown() : acknowledge_first();
      break;
    case 'j':
      move(+1);
      break;
    case 'k':
      move(-1);
      break;
    case 'l':
      go_to({});
      break;
    case 'p':
      begin_push(false, to_all);
      break;
    case 'u':
      begin_push(true, to_all);
      break;
    case '/':
      begin_text(Mode::kFilter);
      break;
    case '?':
      mode_ = Mode::kHelp;
      break;
    default:
      break;
  }
  return true;
}

void Dashboard::begin_push(bool last_good, bool to_all) {
  if (parts_.pusher.report().stage == PushReport::Stage::kPushing) {
    mode_ = Mode::kPush;
    return;
  }
  if (const auto why = parts_.pusher.hindrance(); !why.empty()) return tell("Cannot push: " + why);
  const Robot* robot = parts_.model.team().find(shown_robot());
  if (!robot) return tell("Cannot push: no robot is heard.");
  wish_ = {};
  with_canary_ = false;
  if (!to_all) wish_.robots = {robot->name};
  if (to_all && parts_.model.team().robots().size() > 1) wish_.canary = robot->name;
  if (robot->program) {
    wish_.runs_hash = robot->program->hash;
    for (const auto& file : robot->program->files) wish_.runs.push_back({file.path, file.text});
  }
  if (last_good) return check("");
  begin_text(Mode::kFile);
}

void Dashboard::check(const std::string& file) {
  mode_ = Mode::kPush;
  push_scroll_ = 0;
  wish_.file = file;
  parts_.pusher.check(wish_);
}

void Dashboard::press_with_push(const Press& press) {
  const auto stage = parts_.pusher.report().stage;
  if (press.key == Key::kUp || press.key == Key::kWheelUp) --push_scroll_;
  if (press.key == Key::kDown || press.key == Key::kWheelDown) ++push_scroll_;
  if (stage == PushReport::Stage::kReady && press.letter == 'c' && !wish_.canary.empty())
    with_canary_ = !with_canary_;
  if (stage == PushReport::Stage::kReady && press.letter == 'y') parts_.pusher.push(with_canary_);
  if (stage == PushReport::Stage::kPushing && press.letter == 'c') parts_.pusher.cancel();
  if (press.key != Key::kEscape && press.letter != 'n') return;
  if (stage != PushReport::Stage::kPushing) parts_.pusher.cancel();
  mode_ = Mode::kTeam;
}

std::string Dashboard::push_keys(const PushReport& report) const {
  using Stage = PushReport::Stage;
  if (report.stage == Stage::kPushing) return "c cancel   Esc look at the team, it goes on";
  if (report.stage != Stage::kReady) return "Esc back";
  std::string keys =
      "Push to " + (wish_.robots.empty() ? "all robots" : wish_.robots[0]) + "?  y yes   Esc no";
  if (!wish_.canary.empty())
    keys += with_canary_ ? "   c without the canary " + wish_.canary
                         : "   c " + wish_.canary + " runs it first";
  return keys;
}

}  // namespace galilean::monitor::top
