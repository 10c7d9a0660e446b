// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/protocol/session.h"

namespace galilean::bhdl::lsp {

/// Answers textDocument/completion with what may stand at the cursor, also in a text that does not
/// parse: sections, components, attributes, names of the right kind and type, choices, constants,
/// units.
[[nodiscard]] Json completion(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
