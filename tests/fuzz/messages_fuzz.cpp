// SPDX-License-Identifier: BSD-3-Clause
// Takes random messages as a monitor does: each is checked by its bounds, and what passes is
// decoded and given to the team and to the map. The input is a row of messages: one byte that
// chooses the type, two for the size, and the message in CDR without its header. What is within its
// bounds must be decodable, and the map must end each call.
#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "core/wire/bounds.h"
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
  void add(const wire::Schema& schema, const Bytes& cdr) {
    if (schema.ros_type != M::kRosType) return;
    M message;
    must(msg::decode_cdr(cdr, message), "what is within its bounds can be decoded");
    map_.add(message, clock_.now());
  }

  SteppedClock clock_;
  monitor::Team team_{clock_};
  monitor::TeamMap map_{2s};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kHeadBytes = 3;
  Listener listener;
  std::span<const std::uint8_t> rest(data, size);
  const auto schemas = wire::schemas();
  while (rest.size() > kHeadBytes) {
    const wire::Schema& schema = schemas[rest[0] % schemas.size()];
    const std::size_t most = static_cast<std::size_t>(rest[1]) << 8 | rest[2];
    rest = rest.subspan(kHeadBytes);
    const auto body = rest.first(std::min(most, rest.size()));
    Bytes cdr{0, 1, 0, 0};
    cdr.insert(cdr.end(), body.begin(), body.end());
    listener.take(schema, cdr);
    rest = rest.subspan(body.size());
  }
  return 0;
}
