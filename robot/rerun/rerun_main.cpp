// SPDX-License-Identifier: BSD-3-Clause
// Runs a recorded run again. Standard input has its messages, each behind its length in four bytes,
// the least first: `galilean log rerun` reads them from a recording, and starts one of these for
// each run.
#include <array>
#include <chrono>
#include <iostream>

#include "bhdl/check.h"
#include "core/broken_pipe.h"
#include "core/command_line/command_line.h"
#include "robot/components.h"
#include "robot/rerun/rerun_report.h"

namespace galilean::robot {
namespace {

/// Longer ones are none: a picture has 200 kB, a program less.
constexpr std::uint32_t kLongest = 64U << 20;

struct Options {
  RerunReport report;
  std::string bhdl_file;
  bool only_check = false;
};

/// Reads the next message. Returns false at the end of the stream. Errors: it is no whole message.
Result<bool> read_message(std::istream& in, msg::TickInputs& to) {
  std::array<std::uint8_t, 4> length{};
  in.read(reinterpret_cast<char*>(length.data()), length.size());
  if (in.gcount() == 0) return false;
  std::uint32_t size = 0;
  for (std::size_t i = 0; i < length.size(); ++i) size |= std::uint32_t{length[i]} << 8 * i;
  if (!in || size > kLongest) return Error{"standard input is no stream of messages"};
  std::vector<std::uint8_t> cdr(size);
  in.read(reinterpret_cast<char*>(cdr.data()), size);
  if (!in) return Error{"the stream of messages broke off"};
  to = {};
  if (!msg::decode_cdr(cdr, to)) return Error{"a message is not one of inputs"};
  return true;
}

int fail(const std::string& sentence) {
  std::cerr << "galilean-rerun: " << sentence << '\n';
  return kFailed;
}

int rerun(const Options& options, const Registry& components, std::optional<bhdl::Program> other) {
  const auto began = std::chrono::steady_clock::now();
  Rerun run(components, std::move(other));
  for (msg::TickInputs inputs;;) {
    const auto read = read_message(std::cin, inputs);
    if (!read) return fail(options.report.title + ": " + read.error().message);
    if (!read.value()) break;
    run.take(inputs);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  std::cout << describe(options.report, run.result(), took.count());
  return std::cout.flush() ? exit_code(run.result()) : kFailed;
}

int run(int argc, char** argv) {
  Options options;
  CommandLine app("Runs a recorded run again; galilean log rerun starts it.", "galilean-rerun");
  app.option("--bhdl", options.bhdl_file, "Run this program in place of the recorded one")
      .names_file(".bhdl");
  app.flag("--check", options.only_check,
           "Only tell what is wrong with that program, and what is suspect; without it, the run "
           "tells only why there is none");
  app.option("--title", options.report.title, "What the report calls the run");
  app.flag("--json", options.report.as_json, "Report in one line of JSON");
  if (const auto code = app.parse(argc, argv)) return *code;
  ignore_broken_pipes();
  std::ios::sync_with_stdio(false);
  Registry components;
  add_components(components);
  if (options.bhdl_file.empty()) return rerun(options, components, std::nullopt);
  options.report.other_program = true;
  auto checked = bhdl::check_file(options.bhdl_file, components.catalog());
  if (options.only_check || !checked.program)
    for (const auto& diagnostic : checked.diagnostics) std::cerr << format(diagnostic) << '\n';
  if (!checked.program) return kFailed;
  if (options.only_check) return 0;
  return rerun(options, components, std::move(checked.program));
}

}  // namespace
}  // namespace galilean::robot

int main(int argc, char** argv) {
  try {
    return galilean::robot::run(argc, argv);
  } catch (const std::exception& problem) {
    std::cerr << "galilean-rerun: " << problem.what() << '\n';
    return 1;
  }
}
