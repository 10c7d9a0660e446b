// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/protocol/session.h"

namespace galilean::bhdl::lsp {

/// Answers textDocument/prepareRename with the name at the cursor, or null if there is none or the
/// program does not declare it.
[[nodiscard]] Json prepare_rename(const Session& session, const Json& params);

/// Answers textDocument/rename in every file of the programs concerned. Refuses a new name that
/// could not be read, that is taken, or that would bring errors into a program without errors.
[[nodiscard]] Json rename(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
