// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/session.h"

namespace galilean::bhdl::lsp {

/// textDocument/prepareRename: the name at the cursor; null where there is none, or where the
/// program does not declare it.
[[nodiscard]] Json prepare_rename(const Session& session, const Json& params);

/// textDocument/rename, in every file of the programs concerned. Refuses a new name that could not
/// be read, that is taken, or with which a program that is right would be right no more.
[[nodiscard]] Json rename(const Session& session, const Json& params);

}  // namespace galilean::bhdl::lsp
