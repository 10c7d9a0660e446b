// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/map_tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/command_line/exit_code.h"
#include "monitor/logs/reading/undecoded.h"
#include "monitor/record/damage_text.h"
#include "monitor/schemas/message_trees.h"

namespace galilean::logs {
namespace {

using Tree = monitor::MessageTree;

constexpr const char* kMapCommand = "galilean log plot";
constexpr const char* kGridType = "nav_msgs/msg/OccupancyGrid";
/// More cells than any hall has.
constexpr std::size_t kMostCells = 64'000'000;

struct TrackSource {
  const char* ros_type;
  MapTracks::Source source;
};
/// The better ones first.
constexpr std::array kTrackSources{
    TrackSource{"galilean_msgs/msg/ObjectMap", MapTracks::Source::kTeamMap},
    TrackSource{"galilean_msgs/msg/SimulationState", MapTracks::Source::kTruth},
    TrackSource{"galilean_msgs/msg/RobotState", MapTracks::Source::kDeadReckoning}};

/// Returns a field that schemas of other releases may lack, or nullptr.
const Tree* field_in(const Tree& tree, const char* name) {
  if (!tree.is_object()) return nullptr;
  const auto found = tree.find(name);
  return found == tree.end() ? nullptr : &*found;
}

std::optional<double> figure_in(const Tree& tree, const char* name) {
  const auto* field = field_in(tree, name);
  if (!field || !field->is_number()) return std::nullopt;
  const double figure = field->get<double>();
  return std::isfinite(figure) ? std::optional(figure) : std::nullopt;
}

std::string word_in(const Tree& tree, const char* name) {
  const auto* field = field_in(tree, name);
  return field && field->is_string() ? field->get<std::string>() : "";
}

std::optional<DrawnPoint> place_in(const Tree& tree) {
  const auto x = figure_in(tree, "x_m"), y = figure_in(tree, "y_m");
  return x && y ? std::optional(DrawnPoint{*x, *y}) : std::nullopt;
}

/// Calls `take` with each element of a list that has a place.
template <class Take>
void for_each_place(const Tree& tree, const char* list, const Take& take) {
  const auto* all = field_in(tree, list);
  if (!all || !all->is_array()) return;
  for (const auto& each : *all)
    if (const auto place = place_in(each)) take(each, *place);
}

void take_team_map(const Tree& tree, MapTracks& to) {
  for_each_place(tree, "robots", [&](const Tree& robot, const DrawnPoint& at_m) {
    to.tracks[word_in(robot, "name")].add(at_m);
  });
  to.things.clear();
  for_each_place(tree, "objects", [&](const Tree& thing, const DrawnPoint& at_m) {
    to.things.push_back({word_in(thing, "object_class"), at_m});
  });
}

void take_truth(const Tree& tree, MapTracks& to) {
  to.things.clear();
  for_each_place(tree, "bodies", [&](const Tree& body, const DrawnPoint& at_m) {
    if (word_in(body, "kind") == "robot")
      to.tracks[word_in(body, "name")].add(at_m);
    else
      to.things.push_back({word_in(body, "kind"), at_m});
  });
}

void take_tracks(const Tree& tree, MapTracks& to) {
  if (to.source == MapTracks::Source::kTeamMap) return take_team_map(tree, to);
  if (to.source == MapTracks::Source::kTruth) return take_truth(tree, to);
  if (const auto at_m = place_in(tree)) to.tracks[word_in(tree, "robot")].add(*at_m);
}

std::optional<MapFloor> floor_in(const Tree& tree) {
  const auto *info = field_in(tree, "info"), *data = field_in(tree, "data");
  if (!info || !data || !data->is_array()) return std::nullopt;
  const auto resolution = figure_in(*info, "resolution"), width = figure_in(*info, "width"),
             height = figure_in(*info, "height");
  const auto* origin = field_in(*info, "origin");
  const auto* position = origin ? field_in(*origin, "position") : nullptr;
  if (!resolution || *resolution <= 0 || !width || !height || !position) return std::nullopt;
  MapFloor floor{
      .resolution_m = *resolution,
      .width = static_cast<std::size_t>(std::max(0.0, *width)),
      .height = static_cast<std::size_t>(std::max(0.0, *height)),
      .origin_m = {figure_in(*position, "x").value_or(0), figure_in(*position, "y").value_or(0)},
      .cells = {}};
  if (floor.width > kMostCells || floor.height > kMostCells ||
      floor.width * floor.height != data->size())
    return std::nullopt;
  for (const auto& cell : *data)
    floor.cells.push_back(cell.is_number_integer() ? cell.get<int>() : -1);
  return floor;
}

/// Reads the tracks of one source; the newest floor is decoded at the end, because it is large.
class TrackReader {
 public:
  TrackReader(const Recording& recording, const TrackSource& source)
      : recording_(recording),
        source_(source),
        trees_(recording.summary()),
        undecoded_(kMapCommand) {
    read_.tracks.source = source.source;
  }

  /// Errors: a topic is not there.
  Result<ReadTracks> read(Selection selection) {
    auto messages = SelectedMessages::of(recording_, selection);
    if (!messages) return messages.error();
    while (const mcap::Message* message = messages.value().next()) take(*message);
    take_floor();
    const int undecoded = undecoded_.finish();
    read_.code = std::max(undecoded, tell_damage(kMapCommand, messages.value()));
    return std::move(read_);
  }

 private:
  [[nodiscard]] std::string type_of(std::uint16_t id) const {
    const auto channel = recording_.summary().channels.find(id);
    if (channel == recording_.summary().channels.end()) return "";
    const auto schema = recording_.summary().schemas.find(channel->second.schema_id);
    return schema == recording_.summary().schemas.end() ? "" : schema->second.name;
  }

  void take(const mcap::Message& message) {
    const auto type = type_of(message.channel_id);
    if (type == kGridType) {
      grid_ = message;
      grid_bytes_.assign(message.data.begin(), message.data.end());
    }
    if (type != source_.ros_type) return;
    const auto tree = trees_.decode(message);
    if (tree)
      take_tracks(tree.value(), read_.tracks);
    else
      undecoded_.add(monitor::topic_of(message.channel_id, recording_.summary()),
                     tree.error().message);
  }

  void take_floor() {
    if (!grid_) return;
    grid_->data = grid_bytes_;
    if (const auto tree = trees_.decode(*grid_)) read_.tracks.floor = floor_in(tree.value());
  }

  const Recording& recording_;
  const TrackSource& source_;
  monitor::MessageTrees trees_;
  Undecoded undecoded_;
  std::optional<mcap::Message> grid_;  ///< the newest; its data is in `grid_bytes_`
  mcap::Bytes grid_bytes_;
  ReadTracks read_;
};

std::vector<std::string> topics_of_type(const mcap::Summary& summary, const std::string& type) {
  std::vector<std::string> topics;
  for (const auto& [id, channel] : summary.channels) {
    const auto schema = summary.schemas.find(channel.schema_id);
    if (schema != summary.schemas.end() && schema->second.name == type)
      topics.push_back(channel.topic);
  }
  return topics;
}

}  // namespace

void MapTrack::add(const DrawnPoint& at_m) {
  if (!points_m_.empty() && points_m_.back() == at_m) return;
  if (passed_++ % every_ != 0) return;
  if (points_m_.size() == kMostPoints) {
    for (std::size_t i = 0; i < kMostPoints / 2; ++i) points_m_[i] = points_m_[2 * i];
    points_m_.resize(kMostPoints / 2);
    every_ *= 2;
  }
  points_m_.push_back(at_m);
}

Result<ReadTracks> read_tracks(const Recording& recording, double from_s,
                               std::optional<double> to_s) {
  for (const auto& source : kTrackSources) {
    Selection selection{.topics = topics_of_type(recording.summary(), source.ros_type),
                        .from_s = from_s,
                        .to_s = to_s};
    if (selection.topics.empty()) continue;
    if (source.source == MapTracks::Source::kTeamMap)
      for (auto& topic : topics_of_type(recording.summary(), kGridType))
        selection.topics.push_back(std::move(topic));
    auto read = TrackReader(recording, source).read(std::move(selection));
    if (!read || !read.value().tracks.tracks.empty()) return read;
  }
  const auto part = part_text({.topics = {}, .from_s = from_s, .to_s = to_s});
  return Error{recording.path() + part +
               " tells of no robot where it was: neither /team/objects nor /simulation/state nor a "
               "robot's state is in it"};
}

}  // namespace galilean::logs
