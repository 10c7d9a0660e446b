#include "monitor/server/push_desk.h"

#include <algorithm>
#include <boost/asio/steady_timer.hpp>

namespace galilean::monitor {
namespace {

/// Replies to older pushes (a late rollback) are no longer told apart.
constexpr std::size_t kMostOpen = 64;

std::string names_of(const Team& team) {
  std::string names;
  for (const auto& [name, robot] : team.robots()) names += (names.empty() ? "" : ", ") + name;
  return names.empty() ? "no robot was heard yet" : "known are " + names;
}

}  // namespace

struct PushDesk::Open {
  Push push;
  boost::asio::steady_timer patience;
  Done done = nullptr;
};

PushDesk::PushDesk(const Parts& parts, wire::Participant& participant)
    : parts_(parts), writer_(participant, wire::kProgramPushTopic) {}

PushOutcome PushDesk::find_targets(const PushOrder& order, std::vector<Target>& targets) const {
  using Kind = PushOutcome::Kind;
  for (const auto& name : order.targets) {
    const Robot* robot = parts_.team.find(name);
    if (!robot)
      return {.kind = Kind::kUnknownTarget,
              .detail = "There is no robot '" + name + "'; " + names_of(parts_.team) + "."};
    targets.push_back(target_of(*robot));
  }
  if (order.targets.empty())
    for (const auto& [name, robot] : parts_.team.robots())
      if (!parts_.team.silent(robot)) targets.push_back(target_of(robot));
  if (targets.empty())
    return {.kind = Kind::kNobody, .detail = "No robot is heard; nothing was pushed."};
  return {};
}

void PushDesk::order(PushOrder order, Done done) {
  std::vector<Target> targets;
  auto outcome = find_targets(order, targets);
  if (!outcome.detail.empty()) return done(std::move(outcome));
  auto check = [files = order.files, targets = std::move(targets), &library = parts_.library] {
    return check_for(files, targets, library);
  };
  parts_.worker.run(std::move(check),
                    [this, order = std::move(order), done = std::move(done)](TargetCheck checked) {
                      push_checked(order, std::move(checked), done);
                    });
}

void PushDesk::push_checked(const PushOrder& order, TargetCheck check, Done done) {
  if (!check.result.program)
    return done({.kind = PushOutcome::Kind::kBroken,
                 .detail = "The program has errors; nothing was pushed.",
                 .check = std::move(check)});
  const auto open = register_push(
      make_push(*check.result.program, order.author, order.targets, order.replaces_hash));
  open->done = std::move(done);
  send(open);
}

std::shared_ptr<PushDesk::Open> PushDesk::register_push(msg::ProgramPush message) {
  std::vector<std::string> awaited, given_up;
  for (const auto& [name, robot] : parts_.team.robots()) {
    const bool named = std::ranges::find(message.targets, name) != message.targets.end();
    if (message.targets.empty() || named)
      (parts_.team.silent(robot) ? given_up : awaited).push_back(name);
  }
  if (message.targets.empty()) parts_.team.note_push(message.hash);
  auto open = std::make_shared<Open>(Open{Push(std::move(message), awaited, parts_.clock.now()),
                                          boost::asio::steady_timer(parts_.io)});
  for (const auto& name : given_up) open->push.list(name);
  open_.push_back(open);
  if (open_.size() > kMostOpen) open_.pop_front();
  return open;
}

void PushDesk::send(const std::shared_ptr<Open>& open) {
  open->patience.expires_after(kPatience);
  open->patience.async_wait([this, open](boost::system::error_code) { finish(open); });
  // Written down before it is sent: what reached a robot is never missing from the history.
  parts_.worker.run(
      [this, message = open->push.message()]() -> std::string {
        try {
          parts_.history.add(message);
        } catch (const std::exception& error) {
          return error.what();
        }
        return writer_.write(message) ? "" : "DDS did not take the program; try again.";
      },
      [open](const std::string& failure) {
        if (failure.empty()) return;
        if (const auto done = std::exchange(open->done, nullptr))
          done({.kind = PushOutcome::Kind::kFailed, .detail = failure});
      });
}

void PushDesk::finish(const std::shared_ptr<Open>& open) {
  auto done = std::exchange(open->done, nullptr);
  open->patience.cancel();
  if (!done) return;
  PushOutcome outcome;
  outcome.id = open->push.message().id;
  outcome.hash = open->push.message().hash;
  outcome.answers = open->push.answers();
  done(std::move(outcome));
}

void PushDesk::note(const msg::ProgramPush& push) {
  for (const auto& open : open_)
    if (open->push.message().id == push.id) return;
  register_push(push);
  parts_.worker.run([this, push] { parts_.history.add(push); });
}

void PushDesk::note(const msg::ProgramReply& reply) {
  for (const auto& open : open_) {
    if (!open->push.note(reply, parts_.clock.now())) continue;
    for (const auto& answer : open->push.answers())
      if (answer.robot == reply.robot)
        parts_.worker.run([this, id = reply.id, answer] { parts_.history.add_answer(id, answer); });
    if (open->push.complete()) finish(open);
    return;
  }
}

}  // namespace galilean::monitor
