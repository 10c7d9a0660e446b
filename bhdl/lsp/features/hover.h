// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/protocol/session.h"

namespace galilean::bhdl::lsp {

/// Answers textDocument/hover: a component's law and attributes; an attribute's type, unit,
/// default, range and help; a name's declaration with its comment; the writers of a bit. The answer
/// is null if there is nothing to show.
[[nodiscard]] Json hover(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
