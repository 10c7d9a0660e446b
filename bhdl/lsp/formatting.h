// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/session.h"

namespace galilean::bhdl::lsp {

/// textDocument/formatting: the one layout of `galilean bhdl fmt`, as an edit of the lines that
/// change. Refuses a file with a mistake in its syntax, with what it is.
[[nodiscard]] Json formatting(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
