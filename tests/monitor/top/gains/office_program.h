// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <sstream>

#include "bhdl/program/catalog_file.h"
#include "bhdl/source/source_file.h"

namespace galilean::monitor::top {

[[nodiscard]] inline std::string contents(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(GALILEAN_SOURCE_DIR "/" + path).rdbuf();
  return text.str();
}

/// The catalog of the robots that ship, as far as it has roles. The page's tests read it, too.
[[nodiscard]] inline Catalog office_catalog() {
  return bhdl::load_catalog(GALILEAN_SOURCE_DIR "/web/tests/fixture/catalog.json").value();
}

/// The program for the contest that ships.
[[nodiscard]] inline std::vector<bhdl::SourceFile> office_files() {
  std::vector<bhdl::SourceFile> files;
  for (const char* path : {"office_cleanup.bhdl", "office_robot.bhdl"})
    files.push_back({path, contents(std::string("bhdl/programs/") + path)});
  return files;
}

}  // namespace galilean::monitor::top
