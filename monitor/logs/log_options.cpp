// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/log_options.h"

#include "core/command_line/seconds_of.h"

namespace galilean::logs {
namespace {

constexpr const char* kFileHelp = "An MCAP file";

/// Adds an option that takes a time such as "90", "90s" or "1.5min".
template <class Target>
void add_time(CommandLine& command, const std::string& name, Target& target,
              const std::string& help) {
  command.option(
      name,
      [&target](const std::string& text) -> Result<void> {
        const auto seconds = seconds_of(text);
        if (!seconds) return seconds.error();
        target = seconds.value();
        return {};
      },
      help);
}

void add_file(CommandLine& command, std::string& file) {
  command.option("file", file, kFileHelp).required().names_file(".mcap");
}

template <class Holder>
void add_times(CommandLine& command, Holder& times) {
  add_time(command, "--from", times.from_s,
           "Begin so long after the recording's start, such as 90s or 2min, as replay counts it");
  add_time(command, "--to", times.to_s, "End so long after the recording's start");
}

void add_topics(CommandLine& command, std::vector<std::string>& topics) {
  command.option("--topic", topics, "Only these topics, such as io/state").not_empty();
}

void describe_damage(CommandLine& command, const std::string& what) {
  command.describe_exit(kIncomplete,
                        "A part of the recording is damaged, missing or not decoded; " + what);
}

void add_output(CommandLine& command, OutputOptions& output) {
  command.option("--out", output.path, "The recording to write").required().names_file(".mcap");
  command.flag("--replace", output.replace, "Overwrite it if it exists");
  command.option("--compression", output.compression, "How its chunks are compressed")
      .one_of({"zstd", "lz4", "none"})
      .show_default();
  describe_damage(command, "the rest was written.");
}

}  // namespace

CommandLine add_info(CommandLine& app, InfoOptions& options) {
  auto command = app.command("info", "Describe the contents of a recording, and its damage");
  add_file(command, options.file);
  command.flag("--json", options.json, "As JSON, for programs");
  command.flag("--check", options.check,
               "Read every message and compare every checksum; done anyway up to 256 MiB");
  command.describe_exit(kIncomplete,
                        "A part of the recording is damaged or missing, or its recorder counted "
                        "messages that it missed; the rest was described.");
  return command;
}

CommandLine add_cat(CommandLine& app, CatOptions& options) {
  auto command = app.command("cat", "Print messages, in the order of their log times");
  add_file(command, options.file);
  add_topics(command, options.selection.topics);
  command.option("--field", options.field, "Print this field alone, such as stamp.sec or a[0].b")
      .not_empty();
  add_times(command, options.selection);
  command.option("--count", options.count, "End after so many messages").between(1, 1'000'000'000);
  command.flag("--json", options.json, "As JSON, one message a line");
  describe_damage(command, "the rest was printed.");
  return command;
}

CommandLine add_csv(CommandLine& app, CsvOptions& options) {
  auto command = app.command("csv", "Print a topic's messages as comma-separated values");
  add_file(command, options.file);
  command.option("topic", options.topic, "The topic; it may be left out if there is one only")
      .not_empty();
  command.option("--field", options.fields, "Only these fields, such as x_m or items[0].certainty")
      .not_empty();
  add_times(command, options);
  describe_damage(command, "the rest was printed.");
  return command;
}

CommandLine add_stats(CommandLine& app, StatsOptions& options) {
  auto command = app.command(
      "stats", "Tell how often, evenly, large and late messages came, and what fields were");
  add_file(command, options.file);
  add_topics(command, options.selection.topics);
  command.option("--field", options.fields, "Also tell what these fields of the topic were")
      .not_empty();
  add_times(command, options.selection);
  command.flag("--json", options.json, "As JSON, for programs");
  describe_damage(command, "the rest was measured.");
  return command;
}

CommandLine add_plot(CommandLine& app, PlotOptions& options) {
  constexpr int kMostLetters = 1000;
  auto command = app.command(
      "plot", "Draw fields over time, or robots' tracks, as text or as an SVG or PNG picture");
  add_file(command, options.file);
  command.option("values", options.values, "TOPIC.FIELD, such as io/state.x_m; up to 26 of them")
      .takes(1, 26);
  command.flag("--map", options.map,
               "Draw where robots were, over the floor of the team's map if it was recorded");
  add_times(command, options);
  command.option("--width", options.width, "Width of the drawing in letters")
      .between(10, kMostLetters)
      .show_default();
  command.option("--height", options.height, "Its height in lines")
      .between(3, kMostLetters)
      .show_default();
  command.option("--svg", options.pictures.svg, "Write an SVG picture to this file instead")
      .names_file(".svg");
  command.option("--png", options.pictures.png, "Write a PNG picture to this file instead")
      .names_file(".png");
  command.flag("--replace", options.pictures.replace, "Overwrite those files if they exist");
  describe_damage(command, "the rest was drawn.");
  return command;
}

CommandLine add_verify(CommandLine& app, VerifyOptions& options) {
  auto command =
      app.command("verify", "Compare every checksum of recordings, and decode every message");
  command.option("files", options.files, "MCAP files").required().names_file(".mcap");
  command.flag("--json", options.json, "As JSON, for programs");
  command.describe_exit(kFailed, "A file could not be read, or is no recording.");
  command.describe_exit(kIncomplete, "A recording is damaged, or a message is not whole.");
  return command;
}

CommandLine add_diff(CommandLine& app, DiffOptions& options) {
  auto command =
      app.command("diff", "Compare two recordings' topics, types and messages, by their log times");
  command.option("first", options.first, kFileHelp).required().names_file(".mcap");
  command.option("second", options.second, "Another").required().names_file(".mcap");
  add_topics(command, options.topics);
  command.flag("--json", options.json, "As JSON, for programs");
  command.describe_exit(kFailed, "They differ.");
  command.describe_exit(kNotComparable,
                        "The command line is wrong, or the recordings cannot be compared.");
  command.describe_exit(kIncomplete,
                        "They are equal as far as they can be read: one of them is damaged.");
  return command;
}

CommandLine add_coverage(CommandLine& app, CoverageOptions& options) {
  auto command = app.command(
      "coverage", "Tell which states and conditions of their programs robots have exercised");
  command.option("files", options.files, "MCAP files, which are counted together")
      .required()
      .names_file(".mcap");
  command.option("--format", options.format, "What to print: text, JSON, or a graph for Graphviz")
      .one_of({"text", "json", "dot"})
      .show_default();
  command
      .option("--at-least", options.least_percent,
              "Fail unless so many per cent of each program's states, and of its conditions, "
              "were exercised")
      .between(0.0, 100.0);
  command.describe_exit(kFailed, "Less was exercised than --at-least, or nothing can be read.");
  describe_damage(command, "the rest was counted.");
  return command;
}

CommandLine add_rerun(CommandLine& app, RerunOptions& options) {
  auto command = app.command(
      "rerun",
      "Run robots again from what their ticks read (record --inputs), and compare every tick");
  command.option("files", options.files, "MCAP files, the parts of one recording in their order")
      .required()
      .names_file(".mcap");
  command.option("--robot", options.robots, "Only these robots, such as io").not_empty();
  command
      .option("--bhdl", options.bhdl_file,
              "Run this program in place of the one that each robot started with")
      .names_file(".bhdl");
  command.flag("--json", options.json, "As JSON, one line for each run of a robot");
  command.describe_exit(kFailed, "A bit differs, which was told, or a file cannot be read.");
  command.describe_exit(kIncomplete,
                        "No bit differs as far as can be told: inputs are missing or damaged.");
  return command;
}

CommandLine add_slice(CommandLine& app, CopyOptions& options) {
  auto command = app.command("slice", "Write a part of a recording to another");
  command.option("file", options.files, kFileHelp).required().takes(1, 1).names_file(".mcap");
  add_topics(command, options.selection.topics);
  add_times(command, options.selection);
  command.flag("--with-states", options.with_states,
               "Begin with what a late joiner would be told at --from: the newest of each state, "
               "the last events");
  add_output(command, options.output);
  return command;
}

CommandLine add_merge(CommandLine& app, CopyOptions& options) {
  auto command = app.command("merge", "Write several recordings as one, ordered by log time");
  command.option("files", options.files, "MCAP files").required().names_file(".mcap");
  add_topics(command, options.selection.topics);
  add_output(command, options.output);
  return command;
}

CommandLine add_recover(CommandLine& app, CopyOptions& options) {
  auto command = app.command(
      "recover", "Write what can be read of a damaged recording to another, which is whole");
  command.option("file", options.files, kFileHelp).required().takes(1, 1).names_file(".mcap");
  add_output(command, options.output);
  command.describe_exit(kFailed, "Nothing can be read, or the other could not be written.");
  options.read_again = true;
  return command;
}

CommandLine add_convert(CommandLine& app, CopyOptions& options) {
  constexpr int kMostKilobytes = 65536;
  auto command = app.command(
      "convert", "Write a recording anew: compressed otherwise, in order, without what is damaged");
  command.option("file", options.files, kFileHelp).required().takes(1, 1).names_file(".mcap");
  add_output(command, options.output);
  command
      .option("--schema", options.output.schema,
              "Define messages as .msg files do, or in IDL; without it as they are defined")
      .one_of({"ros2msg", "ros2idl"});
  command.option("--chunk-kb", options.output.chunk_kB, "The size of a chunk in kB")
      .between(1, kMostKilobytes)
      .show_default();
  return command;
}

}  // namespace galilean::logs
