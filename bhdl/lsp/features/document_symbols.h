// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/protocol/session.h"

namespace galilean::bhdl::lsp {

/// Answers textDocument/documentSymbol with sections, and in them components, states and constants.
[[nodiscard]] Json document_symbols(const Session& session, const Json& params);

/// Answers textDocument/foldingRange with every block of more than a line, and comments of several
/// lines.
[[nodiscard]] Json folding_ranges(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
