#include "robot/rehearsal/given_schemas.h"

namespace galilean::robot {
namespace {

bool is_on(const Tick& tick, double from_s, double until_s) noexcept {
  return tick.now >= Time{from_seconds(from_s)} && tick.now < Time{from_seconds(until_s)};
}

template <class T>
void describe_time(Declaration<T>& is, double T::*from_s, double T::*until_s, bool T::*valid) {
  is.flag(valid, "valid", true, "whether the variable is known");
  is.number(from_s, "from", unit::kSecond, 0, "from when on");
  is.number(until_s, "until", unit::kSecond, 0, "and until when");
}

}  // namespace

void GivenBits::describe(Declaration<GivenBits>& is) {
  is.help("Makes a bit what an expectation gives.");
  is.updates(&GivenBits::bits_, "bits_variable", "holds the bit");
  is.number(&GivenBits::bit_index_, "bit_index", unit::kNone, 0, "which bit")
      .range(0, 31)
      .bit_of("bits_variable");
  is.flag(&GivenBits::bit_value_, "bit_value", true, "what it is");
  describe_time(is, &GivenBits::from_s_, &GivenBits::until_s_, &GivenBits::valid_);
}

void GivenBits::run(const Tick& tick) {
  if (!is_on(tick, from_s_, until_s_)) return;
  if (!valid_) return bits_->reset(tick.now);
  Bits bits = bits_->value;
  bits.assign(bit_index_, bit_value_);
  bits_->write(bits, 1, tick.now, tick.number);
}

void GivenLocate::describe(Declaration<GivenLocate>& is) {
  is.help("Makes a place what an expectation gives.");
  is.updates(&GivenLocate::locate_, "locate_variable", "the place");
  is.pair(&GivenLocate::position_m_, "position", unit::kMetre, {0, 0}, "of its centre");
  describe_time(is, &GivenLocate::from_s_, &GivenLocate::until_s_, &GivenLocate::valid_);
}

void GivenLocate::run(const Tick& tick) {
  if (!is_on(tick, from_s_, until_s_)) return;
  if (!valid_) return locate_->reset(tick.now);
  locate_->value.position_m = position_m_;
  locate_->mark_written(1, tick.now, tick.number);
}

void add_given_schemas(Registry& registry) {
  registry.add_schema<GivenBits>(kGivenBits);
  registry.add_schema<GivenLocate>(kGivenLocate);
}

}  // namespace galilean::robot
