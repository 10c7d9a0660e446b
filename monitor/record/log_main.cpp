// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "core/command_line/command_line.h"
#include "monitor/record/log_info.h"

namespace {

using namespace galilean;

int info(const std::string& path, bool json) {
  const auto file = mcap::FileSource::open(path);
  if (!file) return std::cerr << "galilean-log: " << file.error().message << '\n', 1;
  const auto summary = mcap::summarize(file.value());
  if (!summary)
    return std::cerr << "galilean-log: " << path << " " << summary.error().message << '\n', 1;
  const auto losses = monitor::told_losses(file.value(), summary.value());
  std::cout << (json ? monitor::describe_json(path, summary.value(), losses)
                     : monitor::describe(path, summary.value(), losses));
  return std::cout.flush() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Describes recordings of the team.", "galilean log");
  app.require_command();
  std::string path;
  bool json = false;
  auto command = app.command("info", "Describe the contents of a recording");
  command.option("file", path, "An MCAP file").required().names_file(".mcap");
  command.flag("--json", json, "As JSON, for programs");
  if (const auto code = app.parse(argc, argv)) return *code;
  return info(path, json);
}
