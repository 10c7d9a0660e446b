// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "core/command_line/command_line.h"
#include "monitor/record/damage_text.h"
#include "monitor/record/log_info.h"

namespace {

using namespace galilean;

struct InfoOptions {
  std::string file;
  bool json = false;
  bool check = false;
};

int fail(const std::string& sentence) {
  std::cerr << "galilean-log: " << sentence << '\n';
  return kFailed;
}

int info(const InfoOptions& options) {
  const auto file = mcap::FileSource::open(options.file);
  if (!file) return fail(file.error().message);
  const auto summary =
      mcap::summarize(file.value(), options.check ? mcap::Depth::kAll : mcap::Depth::kAsNeeded);
  if (!summary) return fail(options.file + " " + summary.error().message);
  std::cout << (options.json ? monitor::describe_json(options.file, summary.value())
                             : monitor::describe(options.file, summary.value()));
  if (!std::cout.flush()) return kFailed;
  return summary.value().recovered() ? kIncomplete : 0;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Describes recordings of the team.", "galilean log");
  app.require_command();
  app.footer("'galilean log check' judges a recording by expectations.");
  InfoOptions options;
  auto command = app.command("info", "Describe the contents of a recording, and its damage");
  command.option("file", options.file, "An MCAP file").required().names_file(".mcap");
  command.flag("--json", options.json, "As JSON, for programs");
  command.flag("--check", options.check,
               "Read every message and compare every checksum; done anyway up to 256 MiB");
  command.describe_exit(kIncomplete,
                        "A part of the recording is damaged or missing; the rest was described.");
  if (const auto code = app.parse(argc, argv)) return *code;
  return info(options);
}
