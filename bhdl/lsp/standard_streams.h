// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lsp/server.h"

namespace galilean::bhdl::lsp {

/// Serves one client over two file descriptors until it says `exit` or closes its end. Returns the
/// process's exit status.
[[nodiscard]] int serve(Server& server, int input, int output);

}  // namespace galilean::bhdl::lsp
