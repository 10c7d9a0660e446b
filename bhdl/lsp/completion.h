// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/session.h"

namespace galilean::bhdl::lsp {

/// textDocument/completion: what may stand at the cursor, in a text that need not parse. Sections,
/// components, attributes, names of the right kind and type, choices, constants, units.
[[nodiscard]] Json completion(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
