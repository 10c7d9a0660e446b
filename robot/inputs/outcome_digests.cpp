// SPDX-License-Identifier: BSD-3-Clause
#include "robot/inputs/outcome_digests.h"

#include "robot/inputs/bit_digest.h"

namespace galilean::robot {
namespace {

void add(BitDigest& digest, const Pose2& pose) noexcept {
  digest.add(pose.position_m);
  digest.add(pose.heading_rad);
}
void add(BitDigest& digest, const Mat2& matrix) noexcept {
  for (int i = 0; i < 4; ++i) digest.add(matrix(i / 2, i % 2));
}
void add(BitDigest& digest, const Shaft& shaft) noexcept {
  add(digest, shaft.pose);
  digest.add(shaft.speed_mps);
  digest.add(shaft.turn_rate_radps);
}
void add(BitDigest& digest, const Image& image) noexcept {
  digest.add(image.frame);
  digest.add(image.captured);
}
void add(BitDigest& digest, const Sighting& sighting) noexcept {
  digest.add(sighting.position_m);
  add(digest, sighting.covariance_m2);
  digest.add(sighting.range_m);
  digest.add(sighting.azimuth_rad);
  for (const auto bound :
       {sighting.left_px, sighting.top_px, sighting.right_px, sighting.bottom_px})
    digest.add(bound);
  digest.add(sighting.area_px);
}
void add(BitDigest& digest, const Locate& locate) noexcept {
  digest.add(static_cast<std::uint8_t>(locate.object));
  digest.add(locate.position_m);
  add(digest, locate.covariance_m2);
  digest.add(locate.radius_m);
  digest.add(locate.sightings_frame);
  for (const Sighting& sighting : locate.sightings) add(digest, sighting);
}
void add(BitDigest& digest, const Bits& bits) noexcept {
  digest.add(bits.value);
}
void add(BitDigest& digest, const Force& force) noexcept {
  digest.add(force.value);
}

template <class T>
BitDigest digest_of(const Variable<T>& variable) noexcept {
  BitDigest digest;
  digest.add(variable.reliability.valid);
  digest.add(variable.reliability.certainty);
  digest.add(variable.reliability.decay_per_s);
  digest.add(variable.reliability.stamp);
  digest.add(variable.written_tick);
  digest.add(variable.constant);
  add(digest, variable.value);
  return digest;
}

void add_standstill(BitDigest& digest, const TickView& view) noexcept {
  digest.add(static_cast<std::uint8_t>(view.standstill.hold));
  digest.add(view.standstill.stopped_at);
  digest.add(view.standstill.break_point);
  digest.add(view.standstill.wait.condition);
  digest.add(view.standstill.wait.since);
  digest.add(view.out_of_service);
}

void add_program(BitDigest& digest, const RunningProgram& program) noexcept {
  digest.add(program.state_since);
  for (const SchemaRunner& schema : program.schemas) {
    digest.add(schema.failed());
    if (schema.failed()) digest.add(schema.failure().view());
  }
}

std::uint64_t rest_of(const TickView& view) noexcept {
  BitDigest digest;
  add(digest, view.pose);
  add_standstill(digest, view);
  digest.add(view.in_probation);
  digest.add(view.overruns);
  if (view.program) add_program(digest, *view.program);
  return digest.value();
}

}  // namespace

std::uint64_t OutcomeDigests::pixels_of(const Variable<Image>& image, std::size_t index) noexcept {
  KnownPicture& known = known_[index];
  const auto& pixels = image.value.pixels;
  if (known.pixels == pixels.data() && known.frame == image.value.frame &&
      known.written_tick == image.written_tick)
    return known.digest;
  BitDigest digest;
  digest.add(std::span<const std::uint8_t>(pixels));
  known = {pixels.data(), image.value.frame, image.written_tick, digest.value()};
  return known.digest;
}

void OutcomeDigests::take(const TickView& view, TickOutcome& to) noexcept {
  to.program = view.program ? view.program->description->id : 0;
  to.state = view.program ? view.program->state : 0;
  to.transitions = view.transitions;
  to.motion = view.motion;
  to.gripper = view.gripper;
  to.rest = rest_of(view);
  to.variables.clear();
  if (!view.program) return;
  view.program->variables.for_each([&]<class T>(const Variable<T>& variable) {
    BitDigest digest = digest_of(variable);
    if constexpr (std::is_same_v<T, Image>) digest.add(pixels_of(variable, to.variables.size()));
    to.variables.push_back(digest.value());
  });
}

}  // namespace galilean::robot
