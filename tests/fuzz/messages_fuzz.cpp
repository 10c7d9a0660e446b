// SPDX-License-Identifier: BSD-3-Clause
// Takes random messages as programs do: each is checked by its bounds, and what passes is decoded,
// and given to the team and to the map. The input is a row of messages: a line with the type's
// name, two bytes for the size, and the message in CDR without its header. Any other line chooses
// a type, too. What is within its bounds must be decodable, what is decoded must be the same when
// it was encoded, and the map must end each call.
#include <algorithm>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/wire/bounds.h"
#include "core/wire/cdr_writer.h"
#include "core/wire/messages.h"
#include "core/wire/schemas.h"
#include "monitor/map/team_map.h"
#include "monitor/team/team.h"
#include "tests/fuzz/input.h"

namespace {

using namespace galilean;
using namespace std::chrono_literals;
using bhdl::must;

using Bytes = std::vector<std::uint8_t>;

class Listener {
 public:
  void take(const wire::Schema& schema, const Bytes& cdr) {
    clock_.advance(50ms);
    if (!wire::fault_of(wire::bounds_of(schema.ros_type), cdr).empty()) return;
    const monitor::Channel channel{1, "rt/io/any", &schema};
    must(team_.receive({channel, 1, 1, std::make_shared<const Bytes>(cdr)}),
         "what is within its bounds can be decoded");
    decode_those_of_others(schema, cdr);
    add<msg::RobotState>(schema, cdr);
    add<msg::Sightings>(schema, cdr);
    add<msg::Variables>(schema, cdr);
    add<msg::Catalog>(schema, cdr);
    add<msg::Program>(schema, cdr);
    map_.update(clock_.now());
    static_cast<void>(team_.statuses());
  }

 private:
  template <class M>
  static M decoded(const Bytes& cdr) {
    M message;
    must(msg::decode_cdr(cdr, message), "what is within its bounds can be decoded");
    M again;
    const auto bytes = msg::encode_cdr(message);
    must(msg::decode_cdr(bytes, again) && msg::encode_cdr(again) == bytes,
         "what is decoded is the same when it was encoded");
    return message;
  }
  template <class M>
  void add(const wire::Schema& schema, const Bytes& cdr) {
    if (schema.ros_type == M::kRosType) map_.add(decoded<M>(cdr), clock_.now());
  }
  template <class... M>
  static void decode_if_it_is_any(const wire::Schema& schema, const Bytes& cdr) {
    ((schema.ros_type == M::kRosType ? static_cast<void>(decoded<M>(cdr)) : void()), ...);
  }
  /// What robots, simulations, recorders and the page's server receive, and the rest of what is
  /// sent.
  static void decode_those_of_others(const wire::Schema& schema, const Bytes& cdr) {
    decode_if_it_is_any<msg::Transition, msg::Forces, msg::ProgramPush, msg::ProgramReply,
                        msg::ProgramRollback, msg::PushProgress, msg::Command, msg::BreakOrder,
                        msg::Breaks, msg::TeamStop, msg::LeaseChange, msg::TickInputs, msg::Score,
                        msg::RefereeCall, msg::ObjectMap, msg::SimulationOrder,
                        msg::SimulationState, msg::SimulationEvent, msg::DiagnosticArray,
                        msg::CompressedImage, msg::OccupancyGrid, msg::Odometry, msg::TFMessage,
                        msg::MarkerArray, msg::Log, msg::Clock>(schema, cdr);
  }

  SteppedClock clock_;
  monitor::Team team_{clock_};
  monitor::TeamMap map_{2s};
};

/// Takes the first line of `rest`, or all of it where that has no end.
std::string_view take_line(std::span<const std::uint8_t>& rest) {
  const auto end = std::ranges::find(rest, std::uint8_t{'\n'});
  const auto size = static_cast<std::size_t>(end - rest.begin());
  const std::string_view line(reinterpret_cast<const char*>(rest.data()), size);
  rest = rest.subspan(std::min(size + 1, rest.size()));
  return line;
}

const wire::Schema& schema_for(std::string_view line) {
  if (const auto* named = wire::find_schema_by_ros_type(line)) return *named;
  const auto schemas = wire::schemas();
  return schemas[(line.empty() ? 0 : static_cast<std::uint8_t>(line[0])) % schemas.size()];
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kSizeBytes = 2;
  Listener listener;
  std::span<const std::uint8_t> rest(data, size);
  while (!rest.empty()) {
    const wire::Schema& schema = schema_for(take_line(rest));
    if (rest.size() < kSizeBytes) break;
    const std::size_t most = static_cast<std::size_t>(rest[0]) << 8 | rest[1];
    rest = rest.subspan(kSizeBytes);
    const auto body = rest.first(std::min(most, rest.size()));
    Bytes cdr{0, 1, 0, 0};
    cdr.insert(cdr.end(), body.begin(), body.end());
    listener.take(schema, cdr);
    rest = rest.subspan(body.size());
  }
  return 0;
}
