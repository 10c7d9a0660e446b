#pragma once

#include <boost/asio/io_context.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/wire/topics.h"
#include "monitor/programs/history.h"
#include "monitor/programs/push.h"
#include "monitor/programs/target_check.h"
#include "monitor/server/worker.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

struct PushOrder {
  std::vector<bhdl::SourceFile> files;
  std::vector<std::string> targets;  ///< empty: the team
  std::string author;
  std::string replaces_hash;
};

/// What came of an order.
struct PushOutcome {
  enum class Kind {
    kPushed,         ///< see `answers`
    kUnknownTarget,  ///< a robot that was never heard
    kNobody,         ///< no robot is there to be asked
    kBroken,         ///< see `check`; nothing was pushed
    kFailed          ///< this machine could not push
  };
  Kind kind = Kind::kPushed;
  std::string detail;  ///< of all but kPushed, one sentence
  std::string id;
  std::string hash;
  std::vector<PushAnswer> answers;
  TargetCheck check;
};

/// Carries pushes out: checked against each target's catalog, written down, sent, and answered for
/// when each robot has answered or kPatience is over. Pushes that others make are written down too.
///
/// Lives on the io_context's thread; checking, the disk and DDS writes happen on a worker's.
class PushDesk {
 public:
  static constexpr auto kPatience = std::chrono::seconds(2);
  using Done = std::function<void(PushOutcome)>;

  struct Parts {
    boost::asio::io_context& io;
    Worker& worker;
    const Clock& clock;
    Team& team;
    const ProgramLibrary& library;
    History& history;  ///< the worker's alone
  };

  PushDesk(const Parts& parts, wire::Participant& participant);

  void order(PushOrder order, Done done);
  /// What DDS brought.
  void note(const msg::ProgramPush& push);
  void note(const msg::ProgramReply& reply);

 private:
  struct Open;

  [[nodiscard]] PushOutcome find_targets(const PushOrder& order,
                                         std::vector<Target>& targets) const;
  void push_checked(const PushOrder& order, TargetCheck check, Done done);
  void send(const std::shared_ptr<Open>& open);
  std::shared_ptr<Open> register_push(msg::ProgramPush message);
  void finish(const std::shared_ptr<Open>& open);
  Parts parts_;
  wire::Writer<msg::ProgramPush> writer_;
  std::deque<std::shared_ptr<Open>> open_;  ///< the newest last; old ones are let go
};

}  // namespace galilean::monitor
