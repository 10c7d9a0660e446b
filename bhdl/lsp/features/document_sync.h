// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/protocol/session.h"

namespace galilean::bhdl::lsp {

/// How much text a client may keep open: so many documents, with so many bytes in all.
inline constexpr std::size_t kMostDocuments = 256;
inline constexpr std::size_t kMostOpenBytes = 16 << 20;

/// Handle textDocument/didOpen, didChange (whole or in parts) and didClose.
void did_open(const Session& session, const Json& params);
void did_change(const Session& session, const Json& params);
void did_close(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
