// SPDX-License-Identifier: BSD-3-Clause
// `galilean VERB …` becomes the program of that verb, which is in the same folder.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <vector>

#include "core/command_line/exit_code.h"
#include "core/standard_output.h"
#include "monitor/front/siblings.h"
#include "monitor/front/verbs.h"

namespace {

using namespace galilean::front;

/// Returns only if the program cannot be executed.
int become(const Verb& verb, char** rest) {
  std::string program = sibling(verb.program), first(verb.first_argument);
  std::vector<char*> arguments{program.data()};
  if (!first.empty()) arguments.push_back(first.data());
  for (; *rest; ++rest) arguments.push_back(*rest);
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
  std::cerr << "galilean: " << program << " cannot be started: " << std::strerror(errno)
            << (errno == ENOENT ? "; it has not been built: demo.sh builds it while the demo runs, "
                                  "scripts/build.sh at once"
                                : "")
            << '\n';
  return galilean::kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  galilean::tell_unwritten_output();
  const std::string name = argc > 1 ? argv[1] : "";
  if (name == "version" || name == "--version")
    return std::cout << "galilean " GALILEAN_VERSION "\n", 0;
  if (name == "help" || name == "--help" || name == "-h") return std::cout << usage(), 0;
  if (name.empty()) return std::cerr << usage(), galilean::kWrongUsage;
  const std::string two_words = argc > 2 ? name + ' ' + argv[2] : "";
  if (const Verb* verb = find_verb(two_words)) return become(*verb, argv + 3);
  if (const Verb* verb = find_verb(name)) return become(*verb, argv + 2);
  return std::cerr << unknown_verb(name) << '\n', galilean::kWrongUsage;
}
