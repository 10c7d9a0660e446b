// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bhdl/lsp/documents/workspace.h"
#include "bhdl/lsp/protocol/json_rpc.h"

namespace galilean::bhdl::lsp {

/// The client's abilities that change an answer.
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

/// What request handlers use. They read `params` as the protocol describes it. If `params` is
/// different, nlohmann::json's exceptions pass through.
struct Session {
  Workspace& workspace;
  const Vocabulary& vocabulary;
  const Client& client;

  /// Returns the file of `textDocument`. Refuses one that cannot be read.
  [[nodiscard]] FilePointer file(const Json& params) const;
  /// Returns the byte of `position`.
  [[nodiscard]] std::size_t offset(const ParsedFile& file, const Json& params) const;
  [[nodiscard]] Json range(const ParsedFile& file, ByteRange bytes) const;
  [[nodiscard]] ByteRange bytes(const ParsedFile& file, const Json& range) const;
  [[nodiscard]] Json location(const ParsedFile& file, ByteRange bytes) const;
};

/// Reads a `position` of the protocol.
[[nodiscard]] TextPosition position_from(const Json& json);

/// Returns a WorkspaceEdit that the client understands, from the TextEdits of each path.
[[nodiscard]] Json workspace_edit(const Session& session,
                                  const std::map<std::string, Json>& edits_of_path);

}  // namespace galilean::bhdl::lsp
