// SPDX-License-Identifier: BSD-3-Clause
// idl_compiler OUTPUT_DIR A.idl B.idl … makes from the messages' IDL:
//   messages.h    plain C++ structs, with `decode` from CDR
//   lending.{h,cpp}  each as the C struct that Cyclone writes, borrowing its memory
//   schemas.cpp   the IDL text of every type with what it includes, for log files and browsers
//   bounds.cpp    what checks each message by its bounds, which stand in A.bounds beside A.idl
// Each message is thus declared once. Requires: a file stands behind those that it includes.
#include <fstream>
#include <iostream>
#include <sstream>

#include "core/wire/generate/bounds.h"
#include "core/wire/generate/emit.h"
#include "core/wire/generate/emit_bounds.h"

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

/// Returns the path of the bounds that stand beside the IDL.
std::string bounds_file(const std::string& idl) {
  return idl.substr(0, idl.rfind('.')) + ".bounds";
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string output = argv[1];
    std::vector<galilean::idl::File> files;
    galilean::idl::AllBounds bounds;
    for (int i = 2; i < argc; ++i) {
      files.push_back(galilean::idl::parse(stem(argv[i]), read_file(argv[i])));
      galilean::idl::parse_bounds(files.back(), read_file(bounds_file(argv[i])), bounds);
    }
    std::ofstream(output + "/messages.h") << galilean::idl::emit_structs(files);
    std::ofstream(output + "/lending.h") << galilean::idl::emit_lending_header(files);
    std::ofstream(output + "/lending.cpp") << galilean::idl::emit_lending(files);
    std::ofstream(output + "/schemas.cpp") << galilean::idl::emit_schemas(files);
    std::ofstream(output + "/bounds.cpp") << galilean::idl::emit_bounds(files, bounds);
    return 0;
  } catch (const std::exception& problem) {
    std::cerr << problem.what() << '\n';
    return 1;
  }
}
