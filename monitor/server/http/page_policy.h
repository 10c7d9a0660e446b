// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::monitor {

/// Returns the Content-Security-Policy of the page whose index.html is `html`. A browser then runs
/// the page's own files, and those scripts that stand in `html` now as `<script>`, without an
/// attribute: the policy has their hashes. Any other script in the page is none of ours.
[[nodiscard]] std::string page_policy(std::string_view html);

}  // namespace galilean::monitor
