// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/command/recording_options.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "core/command_line/command_line.h"
#include "core/command_line/domain_option.h"
#include "core/command_line/exit_code.h"
#include "core/command_line/seconds_of.h"
#include "core/visible_text.h"
#include "monitor/record/command/about.h"
#include "monitor/record/command/expression_trigger.h"
#include "monitor/record/size_text.h"

namespace galilean::monitor {
namespace {

/// What users write for standard output.
constexpr std::array<std::string_view, 4> kStandardOutputNames{kStandardOutput, "/dev/stdout",
                                                               "/dev/fd/1", "/proc/self/fd/1"};

/// Thirty years, which a Duration can hold.
constexpr double kLongest_s = 1e9;

/// The words that stand for what an option chooses.
struct Words {
  std::string schema = "ros2msg", compression = "fast", pictures = "all";
  double split_duration_s = 0;
  int most_files = 0;
  bool no_images = false;
};

/// Returns what reads an option into `target`, which must live until the options are read.
CommandLine::Reader size_into(std::uint64_t& target) {
  return [&target](const std::string& text) -> Result<void> {
    const auto bytes = bytes_of(text);
    if (!bytes) return bytes.error();
    target = bytes.value();
    return {};
  };
}

/// As size_into, for what has no meaning at 0.
CommandLine::Reader size_above_0_into(std::uint64_t& target) {
  return [&target](const std::string& text) -> Result<void> {
    if (auto read = size_into(target)(text); !read) return read;
    if (target > 0) return {};
    return Error{"the value must be above 0, and not '" + visible(text) + "'"};
  };
}

/// An empty expression matches everything, and is the text of a variable that is not set.
Result<std::regex> expression_of(const std::string& text) try {
  if (text.empty()) return Error{"the value is empty; give one, or leave the option out"};
  return std::regex(text, std::regex::optimize);
} catch (const std::regex_error& error) {
  return Error{"'" + visible(text) + "' is not a valid regular expression: " + error.what()};
}

/// As size_into. A day is as much as anybody keeps in memory.
CommandLine::Reader time_into(Duration& target) {
  return [&target](const std::string& text) -> Result<void> {
    constexpr double kDay_s = 86'400;
    const auto seconds = seconds_of(text);
    if (!seconds) return seconds.error();
    if (seconds.value() > kDay_s) return Error{"'" + visible(text) + "' is more than a day"};
    target = from_seconds(seconds.value());
    return {};
  };
}

/// As size_into.
CommandLine::Reader expressions_into(std::vector<std::regex>& target) {
  return [&target](const std::string& text) -> Result<void> {
    auto expression = expression_of(text);
    if (!expression) return expression.error();
    target.push_back(std::move(expression).value());
    return {};
  };
}

void add_what(CommandLine& app, RecordingOptions& options, Words& words) {
  app.options("--topics", expressions_into(options.selection.topics),
              "Record only topics whose names match one of these regular expressions somewhere, "
              "such as '^/io/|score'");
  app.options("--exclude", expressions_into(options.selection.excluded),
              "Leave out topics whose names match one of these regular expressions somewhere");
  app.option("--pictures", words.pictures,
             "Which pictures to record: none, those of cameras, or those of the channels that "
             "robots make of them, too")
      .one_of({"none", "camera", "all"})
      .show_default();
  app.flag("--no-images", words.no_images, "The same as --pictures none");
  app.option("--picture-rate", size_into(options.picture_bytes_per_s),
             "Leave pictures out beyond this many bytes a second, such as 2MB; 0: leave out none")
      .describe_default("200kB");
  app.flag("--inputs", options.selection.inputs,
           "Record what each tick of the robots read, too, so that 'galilean log rerun' can run "
           "them again, whatever --topics says; about 1 MB a second for a robot with a camera");
  app.option("--schema", words.schema,
             "How the recording defines its messages: as .msg files do, which PlotJuggler and ROS "
             "2 read, or in IDL")
      .one_of({"ros2msg", "ros2idl"})
      .show_default();
}

void add_where(CommandLine& app, RecordingOptions& options, Words& words) {
  app.option("--out", options.plan.out,
             "File to write, such as run.mcap, or '-' for standard output")
      .required()
      .names_file(".mcap");
  app.flag("--replace", options.plan.replace, "Overwrite files that exist");
  app.option("--compression", words.compression,
             "How chunks are compressed: not at all, fast by zstd, small by zstd, which takes "
             "several times as long, or by LZ4")
      .one_of({"none", "fast", "small", "lz4"})
      .show_default();
  app.option("--split-size", size_above_0_into(options.plan.split_bytes),
             "Write run_0.mcap, and go on in run_1.mcap whenever a file has this size, such as "
             "500MB");
  app.option("--split-duration", words.split_duration_s,
             "Go on in another file whenever one is so many seconds old")
      .positive();
  app.option("--max-files", words.most_files, "Delete the oldest file when there are more")
      .positive();
  app.option("--min-free", size_into(options.min_free_bytes),
             "Stand still while less than this is free on the disk, and go on in another file when "
             "there is room; 0: never")
      .describe_default("500MB");
}

/// Returns what reads WORD=VALUE into `about`.
CommandLine::Reader word_into(mcap::Text& about) {
  return [&about](const std::string& text) -> Result<void> {
    const auto equals = text.find('=');
    if (equals == 0 || equals == std::string::npos)
      return Error{"'" + visible(text) + "' is no WORD=VALUE, such as seed=7"};
    const std::string word = text.substr(0, equals);
    if (is_told_anyway(word))
      return Error{"the recorder itself tells '" + word + "'; choose another word"};
    if (about.emplace(word, text.substr(equals + 1)).second) return {};
    return Error{"'" + visible(word) + "' is told twice; choose one of its values"};
  };
}

void add_about(CommandLine& app, RecordingOptions& options) {
  app.option("--name", options.name,
             "How 'galilean record pause' and 'resume' call this recorder; without it, by the name "
             "of its file without .mcap")
      .not_empty();
  app.options("--about", word_into(options.about),
              "Tell this in the metadata 'galilean' of each file: WORD=VALUE, such as seed=7");
}

void add_snapshots(CommandLine& app, RecordingOptions& options) {
  app.option("--on", options.on,
             "Record only what is around an event: when this comes true for a robot, such as "
             "'state is \"break_free\" for 3 s', in the words of docs/EXPECT.md")
      .not_empty()
      .check(ExpressionTrigger::check);
  app.option("--keep-last", time_into(options.snapshots.before),
             "How long before an event a file begins, such as 30s")
      .describe_default("30s");
  app.option("--keep-after", time_into(options.snapshots.after),
             "How long after the last event it ends")
      .describe_default("10s");
  app.option("--keep-memory", size_above_0_into(options.snapshots.most_bytes),
             "How much of that is kept in memory at most")
      .describe_default("64MB");
}

/// Returns which option has no effect beside the others, or nothing.
std::string without_effect(CommandLine& app, const RecordingOptions& options, const Words& words) {
  for (const char* name : {"--keep-last", "--keep-after", "--keep-memory"})
    if (app.find(name).given() && options.on.empty())
      return std::string(name) + " needs --on, which says around what event is recorded";
  if (words.no_images && words.pictures != "none" && app.find("--pictures").given())
    return "--no-images is the same as --pictures none; leave one of the two out";
  if (options.selection.inputs && options.selection.excludes_inputs_of_all())
    return "--exclude leaves out what --inputs asks for; leave one of the two out";
  return "";
}

/// Returns why the options contradict each other, or nothing.
std::string contradiction(CommandLine& app, const RecordingOptions& options, const Words& words) {
  const bool is_split = options.plan.split_bytes > 0 || words.split_duration_s > 0;
  if (words.most_files > 0 && !is_split)
    return "--max-files needs --split-size or --split-duration";
  if (auto problem = without_effect(app, options, words); !problem.empty()) return problem;
  if (options.plan.out != kStandardOutput) return "";
  if (is_split) return "standard output cannot be split; give --out the name of a file";
  if (!options.on.empty()) return "each event has a file of its own; give --out the name of a file";
  if (app.find("--min-free").given() && options.min_free_bytes > 0)
    return "--min-free looks at the disk of a file; give --out the name of one";
  if (isatty(STDOUT_FILENO))
    return "a recording is no text for a terminal; give --out the name of a file, or redirect "
           "standard output";
  return "";
}

void take_words(RecordingOptions& options, const Words& words) {
  if (words.schema == "ros2idl") options.language = SchemaLanguage::kIdl;
  if (words.compression == "none") options.plan.compression = mcap::Compression::kNone;
  if (words.compression == "small") options.plan.compression = mcap::Compression::kSmall;
  if (words.compression == "lz4") options.plan.compression = mcap::Compression::kLz4;
  if (words.pictures == "camera") options.selection.pictures = Pictures::kCamera;
  if (words.pictures == "none" || words.no_images) options.selection.pictures = Pictures::kNone;
  options.plan.split_span = from_seconds(std::min(words.split_duration_s, kLongest_s));
  options.plan.most_files = static_cast<std::size_t>(words.most_files);
  if (options.plan.out == kStandardOutput) options.min_free_bytes = 0;
  if (options.name.empty() && options.plan.out != kStandardOutput)
    options.name = std::filesystem::path(options.plan.out).stem().string();
  if (options.name.empty()) options.name = "standard output";
}

}  // namespace

std::optional<int> read_options(int count, const char* const* arguments,
                                RecordingOptions& options) {
  Words words;
  CommandLine app("Records every topic of the team as MCAP, to be opened by Foxglove or ROS 2.",
                  "galilean record");
  add_where(app, options, words);
  app.option("--duration", options.duration_s,
             "How many seconds to record; without it until Ctrl-C")
      .positive();
  add_what(app, options, words);
  add_snapshots(app, options);
  add_about(app, options);
  add_domain_option(app, options.domain);
  app.describe_exit(kIncomplete, "It is recorded, and messages are missing, which was said.");
  if (const auto code = app.parse(count, arguments)) return code;
  if (std::ranges::find(kStandardOutputNames, options.plan.out) != kStandardOutputNames.end())
    options.plan.out = kStandardOutput;
  if (const auto problem = contradiction(app, options, words); !problem.empty())
    return app.refuse(problem);
  take_words(options, words);
  return std::nullopt;
}

}  // namespace galilean::monitor
