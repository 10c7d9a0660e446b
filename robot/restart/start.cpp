// SPDX-License-Identifier: BSD-3-Clause
#include "robot/restart/start.h"

#include <utility>

#include "bhdl/check.h"
#include "core/catalog/catalog.h"

namespace galilean::robot {
namespace {

/// Returns "office_cleanup.bhdl (0123abcd)".
std::string short_name(const std::string& name, const std::string& hash) {
  return name + " (" + hash.substr(0, 8) + ")";
}

std::string first_error(const bhdl::CheckResult& checked) {
  for (const auto& diagnostic : checked.diagnostics)
    if (diagnostic.severity == bhdl::Severity::kError)
      return diagnostic.file + ":" + std::to_string(diagnostic.line) + ": " + diagnostic.message;
  return "it is no program";
}

/// Begins with the kept program if it can still run. `died` and `of_bhdl` are the parts of the
/// sentence that both outcomes have in common.
void take_up(const KeptProgram& kept, const Catalog& catalog, const std::string& died,
             const std::string& of_bhdl, Start& start) {
  auto checked = bhdl::check(kept.files, catalog);
  if (!checked.program) {
    start.sentence = died +
                     ", which was pushed and confirmed last, but has errors in this release (" +
                     first_error(checked) + "): it runs " + of_bhdl;
    return;
  }
  start.program = std::move(*checked.program);
  start.pushed = true;
  start.sentence = died + ", which was pushed and confirmed last: it runs that again, and not " +
                   of_bhdl + "; begin with --fresh to run that";
}

void begin_after_death(const KeptProgram& kept, const Catalog& catalog, bool fresh, Start& start) {
  const std::string died =
      "the robot program died while it ran " + short_name(kept.files.front().path, kept.hash);
  const std::string of_bhdl = short_name(start.program.name, start.program.hash) + " of --bhdl";
  if (kept.hash == start.program.hash) {
    start.pushed = kept.pushed;
    start.sentence = died + ": it runs that again";
  } else if (fresh) {
    start.sentence = died + ": it runs " + of_bhdl + ", since --fresh says so";
  } else if (kept.pushed) {
    take_up(kept, catalog, died, of_bhdl, start);
  } else {
    start.sentence = died + ": it runs " + of_bhdl + ", since nobody had pushed the other";
  }
}

}  // namespace

Start choose_start(bhdl::Program given, const Result<std::optional<KeptProgram>>& kept,
                   const Catalog& catalog, bool fresh) {
  Start start{.program = std::move(given)};
  const std::string given_name = short_name(start.program.name, start.program.hash);
  if (!kept) {
    start.last_end = LastEnd::kUnknown;
    start.sentence = kept.error().message +
                     "; so it is not known how the robot program ended: it runs " + given_name +
                     " of --bhdl, and writes the file anew";
    return start;
  }
  if (!kept.value()) return start;
  const KeptProgram& before = *kept.value();
  if (before.running) {
    start.last_end = LastEnd::kDied;
    start.orders = before.orders;
    begin_after_death(before, catalog, fresh, start);
  } else if (before.pushed && before.hash != start.program.hash) {
    start.sentence = "it runs " + given_name + " of --bhdl, and not " +
                     short_name(before.files.front().path, before.hash) +
                     ", which somebody had pushed: the robot program ended in order since";
  }
  return start;
}

}  // namespace galilean::robot
