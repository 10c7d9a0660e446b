// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>

#include "bhdl/check.h"
#include "core/wire/reader.h"
#include "core/wire/writer.h"
#include "core/worker.h"
#include "robot/telemetry/order_gate.h"
#include "robot/telemetry/publisher.h"
#include "robot/telemetry/push_ledger.h"

namespace galilean::robot {

/// Takes programs and orders to roll back that accepted senders push over the network. It works in
/// a thread of its own. It checks each program against this robot's catalog, builds it while
/// another one runs, and reports what becomes of it. A refused program changes nothing, and is
/// answered with the reason and every diagnostic.
class ProgramReceiver {
 public:
  /// Requires: `gate` outlives this. Errors: throws std::runtime_error if DDS refuses a topic.
  ProgramReceiver(const TelemetrySource& source, OrderGate& gate, Worker::Report report);

  /// Publisher's thread: answers the pushes of programs that began to run, proved themselves or
  /// failed.
  void on_event(const Event& event);

 private:
  /// More than so many answers a second are for no operator, and would push those to others out.
  static constexpr int kRefusalsEachSecond = 8;

  void wait_and_take(const std::stop_token& stop);
  template <class M>
  void take_from(wire::Reader& reader, const std::string& topic);
  /// Handles a message that is admitted. Errors: its sender is not accepted, or handling it threw.
  template <class M>
  [[nodiscard]] Result<void> handle_from(const OrderGate::Origin& origin, const M& message);
  void handle(const msg::ProgramPush& push);
  void handle(const msg::ProgramRollback& order);
  void wait_until_runs(const std::string& hash) const;
  /// Errors: the push is refused before its program is read.
  [[nodiscard]] Result<void> admit(const msg::ProgramPush& push,
                                   const std::vector<bhdl::SourceFile>& files) const;
  void run_program(bhdl::Program program, const msg::ProgramPush& message, PushLedger::Push push);
  void keep_proven(const Event& event) const;
  void reject(const PushLedger::Push& push, std::string why,
              std::vector<msg::Diagnostic> diagnostics = {});
  /// Answers a message that is not admitted. The gate has told of it, once a sender.
  void refuse(const PushLedger::Push& push, const OrderRefusal& refusal);
  [[nodiscard]] msg::ProgramReply rejection(const PushLedger::Push& push, std::string why,
                                            std::vector<msg::Diagnostic> diagnostics) const;
  void send(msg::ProgramReply reply);
  /// Returns the reply as this robot's of now.
  [[nodiscard]] msg::ProgramReply stamped(msg::ProgramReply reply) const;
  void write(const msg::ProgramReply& reply);
  /// Answers a push that came before as it was answered last. Returns false if it is a new one.
  [[nodiscard]] bool answer_again(const msg::ProgramPush& push);
  void remember(const msg::ProgramReply& reply);
  [[nodiscard]] bool is_answered(const PushLedger::Push& push);

  TelemetrySource source_;
  OrderGate& gate_;
  const bhdl::Vocabulary vocabulary_;
  PushLedger ledger_;
  wire::Writer<msg::ProgramReply> replies_;
  Time refusing_since_{};  ///< the worker's thread alone uses this and the next
  int refusals_ = 0;
  std::mutex answered_mutex_;
  std::deque<msg::ProgramReply> answered_;  ///< the newest reply to each of the newest pushes
  std::mutex mutex_;
  std::condition_variable_any wake_;
  bool arrived_ = true;
  wire::Reader pushes_;
  wire::Reader rollbacks_;
  Worker worker_;
};

}  // namespace galilean::robot
