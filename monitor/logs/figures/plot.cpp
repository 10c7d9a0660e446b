// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/plot.h"

#include <cmath>
#include <iostream>
#include <set>

#include "core/command_line/exit_code.h"
#include "core/visible_text.h"
#include "core/written_files.h"
#include "monitor/logs/figures/chart.h"
#include "monitor/logs/figures/map_drawing.h"
#include "monitor/logs/figures/map_extent.h"
#include "monitor/logs/reading/undecoded.h"
#include "monitor/wire/message_text.h"

namespace galilean::logs {
namespace {

constexpr const char* kPlot = "galilean log plot";

int fail_plot(const std::string& sentence) {
  std::cerr << kPlot << ": " << sentence << '\n';
  return kFailed;
}

/// One of the values that are drawn.
struct Curve {
  std::string topic, field;
  std::set<std::uint16_t> channels = {};
  NamedSeries named = {};
  StateBars bars = {};
};

/// Returns the number of a value; nothing for one that is no finite number.
std::optional<double> number_of(const monitor::MessageTree& value) {
  if (value.is_boolean()) return value.get<bool>() ? 1.0 : 0.0;
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

class Plotting {
 public:
  Plotting(const Recording& recording, const PlotOptions& options)
      : recording_(recording), options_(options), trees_(recording.summary()), undecoded_(kPlot) {}

  /// Errors: a value's topic or field is not there, or has no number and no text.
  Result<void> read() {
    Selection selection{.topics = {}, .from_s = options_.from_s, .to_s = options_.to_s};
    for (const auto& value : options_.values) {
      auto curve = curve_of(value);
      if (!curve) return curve.error();
      selection.topics.push_back(curve.value().topic);
      curves_.push_back(std::move(curve).value());
    }
    auto messages = SelectedMessages::of(recording_, selection);
    if (!messages) return messages.error();
    while (const mcap::Message* message = messages.value().next())
      if (auto done = take(*message, messages.value().at_s()); !done) return done;
    damaged_ = tell_damage(kPlot, messages.value());
    if (!messages.value().any()) return Error{nothing_text(selection, messages.value())};
    return check_numbers();
  }

  [[nodiscard]] std::vector<NamedSeries> series() const {
    std::vector<NamedSeries> all;
    for (const auto& curve : curves_)
      if (curve.named.series.count() > 0) all.push_back(curve.named);
    return all;
  }
  [[nodiscard]] std::vector<NamedBars> bars() const {
    std::vector<NamedBars> all;
    for (const auto& curve : curves_)
      if (!curve.bars.empty()) all.push_back({curve.named.name, curve.bars});
    return all;
  }
  [[nodiscard]] int finish() const { return undecoded_.finish() != 0 ? kIncomplete : damaged_; }

 private:
  Result<Curve> curve_of(const std::string& value) const {
    const auto dot = value.find('.');
    if (dot == 0 || dot == std::string::npos || dot + 1 == value.size())
      return Error{"'" + visible(value) + "' is no TOPIC.FIELD, such as io/state.x_m"};
    Curve curve{.topic = value.substr(0, dot), .field = value.substr(dot + 1)};
    const auto channels = recording_.channels_of(curve.topic);
    if (!channels) return channels.error();
    curve.channels.insert(channels.value().begin(), channels.value().end());
    curve.named.name = value;
    return curve;
  }

  Result<void> take(const mcap::Message& message, double at_s) {
    const auto tree = trees_.decode(message);
    for (auto& curve : curves_) {
      if (!curve.channels.contains(message.channel_id)) continue;
      if (!tree) return undecoded_.add(curve.topic, tree.error().message), Result<void>();
      const auto field = monitor::find_field(tree.value(), curve.field);
      if (!field)
        return Error{"in messages of " + visible(curve.topic) + " " + field.error().message};
      const auto number = field.value() ? number_of(*field.value()) : std::nullopt;
      if (number) curve.named.series.add(at_s, *number);
      if (field.value() && field.value()->is_string())
        curve.bars.add(at_s, field.value()->get_ref<const std::string&>());
    }
    return {};
  }

  Result<void> check_numbers() const {
    for (const auto& curve : curves_)
      if (curve.named.series.count() == 0 && curve.bars.empty())
        return Error{"there is no number and no text of " + visible(curve.named.name) + " to draw"};
    return {};
  }

  const Recording& recording_;
  const PlotOptions& options_;
  monitor::MessageTrees trees_;
  Undecoded undecoded_;
  std::vector<Curve> curves_;
  int damaged_ = 0;
};

/// Returns the exit code.
int plot_map(const Recording& recording, const PlotOptions& options) {
  const auto read = read_tracks(recording, options.from_s, options.to_s);
  if (!read) return fail_plot(read.error().message);
  const auto& tracks = read.value().tracks;
  if (const MapExtent extent(tracks); !extent.is_drawable())
    return fail_plot("a map cannot show places from x = " + short_text(extent.left_m) + " m to " +
                     short_text(extent.right_m) + " m and y = " + short_text(extent.bottom_m) +
                     " m to " + short_text(extent.top_m) +
                     " m; choose a part with --from and --to");
  std::cerr << kPlot << ": " << source_text(tracks.source) << '\n';
  if (!options.pictures.any())
    std::cout << map_text(tracks, static_cast<std::size_t>(options.width),
                          static_cast<std::size_t>(options.height));
  else if (auto done = write_pictures(options.pictures, map_drawing(tracks)); !done)
    return fail_plot(done.error().message);
  return std::cout.flush() ? read.value().code : kFailed;
}

}  // namespace

int plot(const PlotOptions& options) {
  const auto right =
      check_written_files({options.pictures.svg, options.pictures.png}, {options.file});
  if (!right) return fail_plot(right.error().message);
  const auto recording = Recording::open(options.file);
  if (!recording) return fail_plot(recording.error().message);
  if (options.map) return plot_map(recording.value(), options);
  Plotting plotting(recording.value(), options);
  if (auto done = plotting.read(); !done) return fail_plot(done.error().message);
  const auto series = plotting.series();
  const auto bars = plotting.bars();
  if (!options.pictures.any()) {
    std::cout << chart_text(series, static_cast<std::size_t>(options.width),
                            static_cast<std::size_t>(options.height), bars);
  } else if (auto done = write_pictures(options.pictures, chart_drawing(series, bars)); !done) {
    return fail_plot(done.error().message);
  }
  return std::cout.flush() ? plotting.finish() : kFailed;
}

}  // namespace galilean::logs
