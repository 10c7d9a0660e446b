// SPDX-License-Identifier: BSD-3-Clause
// idl_compiler OUTPUT_DIR A.idl B.idl … makes from the messages' IDL:
//   messages.h    plain C++ structs, with `decode` from CDR
//   lending.{h,cpp}  each as the C struct that Cyclone writes, borrowing its memory
//   schemas.cpp   the IDL text of every type with what it includes, for log files and browsers
// Each message is thus declared once. Requires: a file stands behind those that it includes.
#include <fstream>
#include <iostream>
#include <sstream>

#include "core/wire/generate/emit.h"

namespace {

std::string read_file(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + ": cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string stem(const std::string& path) {
  const auto slash = path.rfind('/');
  return path.substr(slash + 1, path.rfind('.') - slash - 1);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string output = argv[1];
    std::vector<galilean::idl::File> files;
    for (int i = 2; i < argc; ++i)
      files.push_back(galilean::idl::parse(stem(argv[i]), read_file(argv[i])));
    std::ofstream(output + "/messages.h") << galilean::idl::emit_structs(files);
    std::ofstream(output + "/lending.h") << galilean::idl::emit_lending_header(files);
    std::ofstream(output + "/lending.cpp") << galilean::idl::emit_lending(files);
    std::ofstream(output + "/schemas.cpp") << galilean::idl::emit_schemas(files);
    return 0;
  } catch (const std::exception& problem) {
    std::cerr << problem.what() << '\n';
    return 1;
  }
}
