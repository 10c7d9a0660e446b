// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/features/diagnostic_publisher.h"

namespace galilean::bhdl::lsp {

/// Answers textDocument/codeAction: for every diagnostic in the range that knows what was meant,
/// the edit that corrects it. Requires: `publisher` is up to date.
[[nodiscard]] Json quick_fixes(const Session& session, const DiagnosticPublisher& publisher,
                               const Json& params);

}  // namespace galilean::bhdl::lsp
