// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bhdl/lsp/features/diagnostic_publisher.h"

namespace galilean::bhdl::lsp {

/// A language server for BHDL that speaks the Language Server Protocol 3.17. It does not send or
/// receive by itself: each call takes the text of one JSON-RPC message and returns the texts to
/// send. Any text gets an answer, and none makes it throw. It serves one client, in one thread.
///
/// Requests are answered at once. The diagnostics of changed texts are put off: the owner of the
/// server calls `work` when no message waits, and sends what it returns.
class Server {
 public:
  Server(const Catalog& catalog, std::unique_ptr<ProgramFolder> folder);

  /// Handles one message. Returns the messages to send, in order: mostly one answer, or nothing.
  [[nodiscard]] std::vector<std::string> receive(std::string_view message);

  [[nodiscard]] bool has_work() const noexcept { return publisher_.due(); }
  [[nodiscard]] std::vector<std::string> work();

  /// Returns the exit status once the client has said `exit`: 0 if it said `shutdown` before, else
  /// 1.
  [[nodiscard]] std::optional<int> exit_status() const noexcept { return exit_status_; }

 private:
  enum class Phase { kNew, kReady, kShutDown };

  [[nodiscard]] std::optional<Json> answer(const Json& message, std::vector<std::string>& before);
  [[nodiscard]] Json request(std::string_view method, const Json& params,
                             std::vector<std::string>& before);
  void notice(std::string_view method, const Json& params);
  [[nodiscard]] Json initialize(const Json& params);
  [[nodiscard]] Session session() { return {workspace_, vocabulary_, client_}; }

  Vocabulary vocabulary_;
  std::unique_ptr<ProgramFolder> folder_;
  Workspace workspace_;
  Client client_;
  DiagnosticPublisher publisher_;
  Phase phase_ = Phase::kNew;
  std::optional<int> exit_status_;
};

}  // namespace galilean::bhdl::lsp
