// SPDX-License-Identifier: BSD-3-Clause
// galilean-log info|cat|csv|stats|plot|verify|diff|coverage|rerun|slice|merge|recover|convert reads
// recordings.
#include <iostream>
#include <sstream>

#include "core/broken_pipe.h"
#include "monitor/logs/log_options.h"
#include "monitor/logs/reading/recording.h"
#include "monitor/record/log_info.h"
#include "monitor/record/told_pauses.h"

namespace {

using namespace galilean;
using namespace galilean::logs;

/// What all commands are asked for; the one that is given reads its own.
struct Options {
  InfoOptions info;
  CatOptions cat;
  CsvOptions csv;
  StatsOptions stats;
  PlotOptions plot;
  VerifyOptions verify;
  DiffOptions diff;
  CoverageOptions coverage;
  RerunOptions rerun;
  CopyOptions slice, merge, recover, convert;
};

int fail(const std::string& sentence) {
  std::cerr << "galilean-log: " << sentence << '\n';
  return kFailed;
}

int print_info(const InfoOptions& options) {
  const auto recording =
      Recording::open(options.file, options.check ? mcap::Depth::kAll : mcap::Depth::kAsNeeded);
  if (!recording) return fail(recording.error().message);
  const auto& summary = recording.value().summary();
  const auto losses = monitor::told_losses(recording.value().source(), summary);
  const auto pauses = monitor::told_pauses(recording.value().source(), summary);
  std::cout << (options.json ? monitor::describe_json(options.file, summary, losses, pauses)
                             : monitor::describe(options.file, summary, losses, pauses));
  if (!std::cout.flush()) return kFailed;
  const bool is_missing = losses && (losses->missing() > 0 || !losses->copies.empty());
  return summary.recovered() || is_missing ? kIncomplete : 0;
}

/// Returns why the times bound no part; empty if they do. Of commands that were not given, they are
/// those of the whole recording.
template <class Times>
std::string wrong_order(const Times& times) {
  if (!times.to_s || *times.to_s >= times.from_s) return {};
  std::ostringstream text;
  text << "--to " << *times.to_s << "s is before --from " << times.from_s
       << "s; a part begins before it ends";
  return text.str();
}

/// Returns what is wrong with the options together; empty if nothing is.
std::string contradiction(const Options& options, bool is_plot) {
  if (is_plot && options.plot.map == !options.plot.values.empty())
    return options.plot.map ? "--map draws no fields; leave them out, or --map"
                            : "plot needs TOPIC.FIELD, such as io/state.x_m, or --map";
  return wrong_order(options.cat.selection) + wrong_order(options.csv) +
         wrong_order(options.stats.selection) + wrong_order(options.plot) +
         wrong_order(options.slice.selection);
}

template <class Run>
int guarded(Run run) try {
  return run();
} catch (const std::exception& error) {
  return fail(error.what());
}

}  // namespace

int main(int argc, char** argv) {
  ignore_file_size_limit();
  Options options;
  CommandLine app("Reads, compares and cuts recordings of the team.", "galilean log");
  app.require_command();
  app.footer("'galilean log check' judges a recording by expectations.");
  const auto info = add_info(app, options.info);
  const auto cat = add_cat(app, options.cat);
  const auto csv = add_csv(app, options.csv);
  const auto stats = add_stats(app, options.stats);
  const auto plotted = add_plot(app, options.plot);
  const auto verify = add_verify(app, options.verify);
  const auto diff = add_diff(app, options.diff);
  const auto coverage = add_coverage(app, options.coverage);
  const auto rerun = add_rerun(app, options.rerun);
  const auto slice = add_slice(app, options.slice);
  const auto merge = add_merge(app, options.merge);
  const auto recover = add_recover(app, options.recover);
  const auto convert = add_convert(app, options.convert);
  if (const auto code = app.parse(argc, argv)) return *code;
  if (const auto wrong = contradiction(options, plotted.chosen()); !wrong.empty())
    return app.refuse(wrong);
  return guarded([&] {
    if (info.chosen()) return print_info(options.info);
    if (cat.chosen()) return print_messages(options.cat);
    if (csv.chosen()) return print_csv(options.csv);
    if (stats.chosen()) return print_statistics(options.stats);
    if (plotted.chosen()) return plot(options.plot);
    if (verify.chosen()) return verify_recordings(options.verify);
    if (diff.chosen()) return print_difference(options.diff);
    if (coverage.chosen()) return print_coverage(options.coverage);
    if (rerun.chosen()) return rerun_recordings(options.rerun);
    if (slice.chosen()) return copy_recordings("slice", options.slice);
    if (merge.chosen()) return copy_recordings("merge", options.merge);
    if (recover.chosen()) return copy_recordings("recover", options.recover);
    return convert.chosen() ? copy_recordings("convert", options.convert) : kWrongUsage;
  });
}
