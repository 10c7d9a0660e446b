// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/map_service.h"

#include <algorithm>
#include <array>
#include <exception>
#include <utility>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/map/export/markers.h"

namespace galilean::monitor {
namespace {

/// Messages are added to the map in each slice, so that little is left to do when it publishes.
constexpr auto kSlice = std::chrono::milliseconds(20);
constexpr Duration kPeriod = std::chrono::milliseconds(200);
constexpr int kPeriodsAGrid = 5;

template <class M>
void add_as(TeamMap& map, const std::vector<std::uint8_t>& cdr, Time at) {
  M decoded;
  if (msg::decode_cdr(cdr, decoded)) map.add(decoded, at);
}

constexpr std::array<std::pair<std::string_view, MapService::Handler>, 5> kHandlers{{
    {msg::RobotState::kRosType, add_as<msg::RobotState>},
    {msg::Sightings::kRosType, add_as<msg::Sightings>},
    {msg::Variables::kRosType, add_as<msg::Variables>},
    {msg::Catalog::kRosType, add_as<msg::Catalog>},
    {msg::Program::kRosType, add_as<msg::Program>},
}};

void forget_named(TeamMap& map, const std::vector<std::uint8_t>& name, Time) {
  map.forget(std::string(name.begin(), name.end()));
}

MapService::Handler handler_for(const Message& message) {
  for (const auto& [type, handler] : kHandlers)
    if (type == message.channel.schema->ros_type) return handler;
  return nullptr;
}

}  // namespace

MapService::MapService(wire::Participant& participant, const Clock& clock, const Options& options)
    : clock_(clock),
      watch_(clock),
      map_(options.silent_after),
      objects_(participant, wire::kObjectsTopic),
      grid_(participant, wire::kMapTopic),
      markers_(participant, wire::kMarkersTopic),
      tf_(participant, wire::kTfTopic) {
  for (const auto& [robot, origin] : options.starts) map_.start_at(robot, origin);
  thread_ = std::thread([this] { run(); });
}

MapService::~MapService() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

void MapService::receive(const Message& message) {
  const Handler handler = handler_for(message);
  if (!handler) return;
  const std::lock_guard lock(mutex_);
  const std::size_t bytes = message.cdr->size();
  if (waiting_.size() >= kMostWaiting || waiting_bytes_ + bytes > kMostWaitingBytes)
    return watch_.note_dropped();
  waiting_.push_back({handler, message.cdr, clock_.now()});
  waiting_bytes_ += bytes;
}

void MapService::forget(const std::string& robot) {
  auto name = std::make_shared<const std::vector<std::uint8_t>>(robot.begin(), robot.end());
  const std::lock_guard lock(mutex_);
  waiting_.push_back({forget_named, std::move(name), clock_.now()});
}

template <class Work>
bool MapService::attempt(Work work) try {
  work();
  return true;
} catch (const std::exception& error) {
  watch_.note_failure(error.what());
  return false;
} catch (...) {
  watch_.note_failure("it threw what is no std::exception");
  return false;
}

// What is due goes by the clock, and not by slices, which last longer where many messages wait.
void MapService::run() {
  auto next = std::chrono::steady_clock::now();
  Time due = clock_.now();
  for (int periods = 0;;) {
    watch_.note_alive();
    next = std::max(next + kSlice, std::chrono::steady_clock::now());
    const auto arrived = arrived_until(next);
    if (!arrived) return;
    const Time began = clock_.now();
    take_in(*arrived);
    if (ending_) return;
    if (clock_.now() < due) continue;
    due += kPeriod;
    if (due < clock_.now()) due = clock_.now() + kPeriod;
    const bool with_grid = periods++ % kPeriodsAGrid == 0;
    const bool is_published = attempt([&] { publish(clock_.now(), with_grid); });
    if (is_published) update_s_ = to_seconds(clock_.now() - began);
  }
}

std::optional<std::vector<MapService::Arrived>> MapService::arrived_until(
    std::chrono::steady_clock::time_point end) {
  std::unique_lock lock(mutex_);
  if (ended_.wait_until(lock, end, [this] { return ending_.load(); })) return std::nullopt;
  waiting_bytes_ = 0;
  return std::exchange(waiting_, {});
}

void MapService::take_in(const std::vector<Arrived>& arrived) {
  for (const auto& [handler, cdr, at] : arrived) {
    if (ending_) return;  // Whoever ends the service does not wait for what has piled up.
    (void)attempt([&, handler = handler, &bytes = *cdr, at = at] { handler(map_, bytes, at); });
    watch_.note_alive();
  }
}

void MapService::publish(Time now, bool with_grid) {
  map_.update(now);
  const auto stamp_ns = wire::wall_clock_ns();
  auto objects = map_.objects(now, stamp_ns);
  // A failed write is ignored, because the next message supersedes this one.
  (void)objects_.write(objects);
  if (const auto frames = map_.transforms(stamp_ns); !frames.transforms.empty())
    (void)tf_.write(frames);
  if (markers_.readers() > 0) (void)markers_.write(markers(objects));
  keep(std::move(objects));
  if (with_grid && !map_.occupancy().empty()) publish_grid(stamp_ns);
}

void MapService::keep(msg::ObjectMap objects) {
  const std::lock_guard lock(mutex_);
  newest_.objects = std::move(objects);
}

void MapService::publish_grid(std::int64_t stamp_ns) {
  auto grid = map_.occupancy().message();
  grid.header = {wire::ros_time(stamp_ns), "map"};
  grid.info.map_load_time = grid.header.stamp;
  (void)grid_.write(grid);
  const std::lock_guard lock(mutex_);
  newest_.grid = std::move(grid);
}

std::optional<MapService::Newest> MapService::newest() const {
  const std::lock_guard lock(mutex_);
  if (newest_.grid.data.empty()) return std::nullopt;
  return newest_;
}

}  // namespace galilean::monitor
