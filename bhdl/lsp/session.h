// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bhdl/lsp/json_rpc.h"
#include "bhdl/lsp/workspace.h"

namespace galilean::bhdl::lsp {

/// What the client can do, as far as it changes an answer.
struct Client {
  PositionEncoding encoding = PositionEncoding::kUtf16;
  bool snippets = false;
  bool markdown = false;
  bool completion_defaults = false;  ///< one edit range for all items
  bool document_changes = false;     ///< edits that name a document's version
  bool symbol_trees = false;
  bool related_information = false;
};
[[nodiscard]] Client read_client(const Json& initialize_params);

/// What answers a request. Everything is read from `params` as the protocol has it; where that is
/// not so, nlohmann::json's exceptions are thrown on.
struct Session {
  Workspace& workspace;
  const Vocabulary& vocabulary;
  const Client& client;

  /// The file of `textDocument`; refuses one that cannot be read.
  [[nodiscard]] FilePointer file(const Json& params) const;
  /// The byte of `position`.
  [[nodiscard]] std::size_t offset(const ParsedFile& file, const Json& params) const;
  [[nodiscard]] Json range(const ParsedFile& file, ByteRange bytes) const;
  [[nodiscard]] ByteRange bytes(const ParsedFile& file, const Json& range) const;
  [[nodiscard]] Json location(const ParsedFile& file, ByteRange bytes) const;
};

/// `position` of the protocol.
[[nodiscard]] TextPosition position_from(const Json& json);

/// A WorkspaceEdit that the client understands; of each path, TextEdits.
[[nodiscard]] Json workspace_edit(const Session& session,
                                  const std::map<std::string, Json>& edits_of_path);

}  // namespace galilean::bhdl::lsp
