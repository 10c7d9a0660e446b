// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/protocol/session.h"

namespace galilean::bhdl::lsp {

/// Answers textDocument/definition: where a name is declared in every program that the file is part
/// of; for an include, the file.
[[nodiscard]] Json definition(const Session& session, const Json& params);

/// Answers textDocument/references: every place of the name, with its declaration if that is asked
/// for.
[[nodiscard]] Json references(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
