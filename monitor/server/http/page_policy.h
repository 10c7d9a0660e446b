// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::monitor {

/// Returns the Content-Security-Policy of the page whose index.html is `html`, but for what it may
/// connect to. A browser then runs the page's own files, and those scripts that stand in `html` now
/// as `<script>`, without an attribute: the policy has their hashes. Any other script in the page
/// is none of ours. No other page may show it in a frame, and nothing in it may send a form or
/// change what its addresses are relative to.
[[nodiscard]] std::string page_policy(std::string_view html);

/// Returns the rest of the policy for a page that was asked for at `host`, such as
/// "localhost:8080": it connects to this host alone. The host's WebSockets are named, because
/// 'self' does not include them in every browser. A host that a policy cannot name, such as an IPv6
/// address, is left out.
[[nodiscard]] std::string connect_policy(std::string_view host);

}  // namespace galilean::monitor
