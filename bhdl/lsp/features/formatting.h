// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/protocol/session.h"

namespace galilean::bhdl::lsp {

/// Answers textDocument/formatting with the layout of `galilean bhdl fmt`, as an edit of the lines
/// that change. Refuses a file with a mistake in its syntax, and says which.
[[nodiscard]] Json formatting(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
