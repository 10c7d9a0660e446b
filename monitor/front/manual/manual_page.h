// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/front/manual/described_verbs.h"

namespace galilean::front {

/// A manual page of section 1.
struct ManualPage {
  std::string name;  ///< such as "galilean-sim-ctl"
  std::string text;  ///< in roff
};

/// Returns the page of a verb. Requires: `verb` is one of `verbs`.
[[nodiscard]] ManualPage page_of(const DescribedVerb& verb,
                                 const std::vector<DescribedVerb>& verbs);
/// Returns the page of `galilean` itself.
[[nodiscard]] ManualPage page_of_galilean(const std::vector<DescribedVerb>& verbs);

}  // namespace galilean::front
