// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/command_line/command_line.h"
#include "monitor/logs/comparing/diff.h"
#include "monitor/logs/comparing/verify.h"
#include "monitor/logs/coverage/coverage.h"
#include "monitor/logs/figures/plot.h"
#include "monitor/logs/figures/stats.h"
#include "monitor/logs/printing/cat.h"
#include "monitor/logs/printing/csv.h"
#include "monitor/logs/rerunning/rerun.h"
#include "monitor/logs/writing/copies.h"

namespace galilean::logs {

/// What `galilean log info` is asked for.
struct InfoOptions {
  std::string file;
  bool json = false;
  bool check = false;
};

// Each adds the command of its name, whose options are written to `options`. They must live until
// the command line is parsed.

[[nodiscard]] CommandLine add_info(CommandLine& app, InfoOptions& options);
[[nodiscard]] CommandLine add_cat(CommandLine& app, CatOptions& options);
[[nodiscard]] CommandLine add_csv(CommandLine& app, CsvOptions& options);
[[nodiscard]] CommandLine add_stats(CommandLine& app, StatsOptions& options);
[[nodiscard]] CommandLine add_plot(CommandLine& app, PlotOptions& options);
[[nodiscard]] CommandLine add_verify(CommandLine& app, VerifyOptions& options);
[[nodiscard]] CommandLine add_diff(CommandLine& app, DiffOptions& options);
[[nodiscard]] CommandLine add_coverage(CommandLine& app, CoverageOptions& options);
[[nodiscard]] CommandLine add_rerun(CommandLine& app, RerunOptions& options);
[[nodiscard]] CommandLine add_slice(CommandLine& app, CopyOptions& options);
[[nodiscard]] CommandLine add_merge(CommandLine& app, CopyOptions& options);
[[nodiscard]] CommandLine add_recover(CommandLine& app, CopyOptions& options);
[[nodiscard]] CommandLine add_convert(CommandLine& app, CopyOptions& options);

}  // namespace galilean::logs
