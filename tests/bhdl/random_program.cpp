// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bhdl/random_program.h"

namespace galilean::bhdl {

std::string damaged(std::string text, RandomProgram& random) {
  static const std::vector<std::string> kPieces{":",
                                                "end",
                                                "\"",
                                                "<",
                                                ")",
                                                ",",
                                                ";",
                                                "-",
                                                "9",
                                                "state:",
                                                "motor_schemas:",
                                                "“",
                                                "\xE2",
                                                "variables:",
                                                "include \"x\"",
                                                "condition:",
                                                "\n",
                                                std::string(1, '\0'),
                                                "name: \"f0\""};
  for (int i = 1 + random.below(8); i > 0 && !text.empty(); --i) {
    const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
    const auto length = static_cast<std::size_t>(random.below(12));
    switch (random.below(4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, random.one_of(kPieces));
        break;
      case 2:
        text.insert(at,
                    text.substr(static_cast<std::size_t>(random.below(static_cast<int>(at) + 1)),
                                length * 4));
        break;
      default:
        text[at] = static_cast<char>(random.below(256));
    }
  }
  return text;
}

}  // namespace galilean::bhdl
