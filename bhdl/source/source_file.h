// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::bhdl {

/// One file of a program as it was read. The main file is the first of a list.
struct SourceFile {
  std::string path;  ///< as `include` names it; the main file's own name
  std::string text;
};

}  // namespace galilean::bhdl
