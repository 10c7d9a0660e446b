// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bhdl/check.h"
#include "bhdl/lsp/protocol/session.h"

namespace galilean::bhdl::lsp {

/// Checks the programs that the open files are part of, and publishes what changed. A program is
/// checked again only when one of its files has changed.
class DiagnosticPublisher {
 public:
  /// Notes that a document was opened, changed or closed.
  void note_change() noexcept { due_ = true; }
  [[nodiscard]] bool due() const noexcept { return due_; }

  /// Returns notifications of textDocument/publishDiagnostics.
  [[nodiscard]] std::vector<Json> publish(const Session& session);
  /// Returns the diagnostics of the last `publish`.
  [[nodiscard]] const std::vector<Diagnostic>& of(const std::string& path) const;

 private:
  using OfPath = std::map<std::string, std::vector<Diagnostic>>;
  struct Checked {
    ProgramFiles files;
    OfPath diagnostics;
  };

  void check_programs(const Session& session);
  [[nodiscard]] OfPath merged(const Session& session) const;

  bool due_ = false;
  std::map<std::string, Checked> checked_;  ///< by the main file's path
  OfPath current_;
  std::map<std::string, std::string> published_;
};

/// Returns the token at the place of a diagnostic, with its quotes.
[[nodiscard]] ByteRange range_of(const ParsedFile& file, const Diagnostic& diagnostic);
[[nodiscard]] Json diagnostic_to_json(const Session& session, const ParsedFile& file,
                                      const Diagnostic& diagnostic);

}  // namespace galilean::bhdl::lsp
