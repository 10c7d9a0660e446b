// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/source/names.h"

#include "bhdl/source/text.h"

namespace galilean::bhdl {

Hint did_you_mean(std::string_view name) {
  return name.empty() ? Hint() : Hint("did you mean " + in_quotes(name) + "?", std::string(name));
}

}  // namespace galilean::bhdl
