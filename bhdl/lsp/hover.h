// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/session.h"

namespace galilean::bhdl::lsp {

/// textDocument/hover: a component's law and attributes; an attribute's type, unit, default, range
/// and help; a name's declaration with the comment on it; what writes a bit. null where there is
/// nothing to tell.
[[nodiscard]] Json hover(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
