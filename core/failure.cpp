// SPDX-License-Identifier: BSD-3-Clause
#include "core/failure.h"

namespace galilean {

std::string text_of(const char* text) noexcept {
  try {
    return *text ? text : "for an unknown reason";
  } catch (...) {
    return "out of memory";  // short enough that std::string needs no memory for it
  }
}

}  // namespace galilean
