// SPDX-License-Identifier: BSD-3-Clause
#include "core/orders/order_check.h"

#include <algorithm>
#include <cmath>

namespace galilean {
namespace {

using Kind = OrderRefusal::Kind;
using Outcome = Result<void, OrderRefusal>;

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr std::int64_t kTolerance_ns = OrderCheck::kClockTolerance.count();

/// Returns the time from one instant to another in whole seconds, such as "12 s". The instants may
/// be any numbers, because a stranger may have chosen them.
std::string seconds_between(std::int64_t from_ns, std::int64_t to_ns) {
  const double seconds =
      static_cast<double>(to_ns) / kNsPerSecond - static_cast<double>(from_ns) / kNsPerSecond;
  return std::to_string(static_cast<long long>(std::round(seconds))) + " s";
}

Outcome check_times(const msg::Signature& signature, const CheckTimes& times) {
  const std::int64_t began_ns = times.now_ns - times.uptime_ns;
  if (signature.expires_ns <= times.now_ns - kTolerance_ns)
    return OrderRefusal{Kind::kExpired,
                        "it expired " + seconds_between(signature.expires_ns, times.now_ns) +
                            " ago; if it was sent just now, set the clocks of both machines"};
  if (signature.issued_ns > times.now_ns + kTolerance_ns)
    return OrderRefusal{Kind::kEarly,
                        "it was signed " + seconds_between(times.now_ns, signature.issued_ns) +
                            " after this robot's time; set the clocks of both machines"};
  // What was seen before a restart is forgotten. Nothing of then may be carried out again.
  if (signature.issued_ns < began_ns)
    return OrderRefusal{Kind::kOfBefore, "it was signed before this robot started; give it again"};
  return {};
}

}  // namespace

std::string with_advice(const OrderRefusal& refusal) {
  if (refusal.kind != Kind::kUntrusted) return refusal.why;
  return refusal.why +
         "; sign it with --key FILE, or add what 'galilean keys' prints to the file of the robot's "
         "--trust";
}

Outcome OrderCheck::accept(const msg::Signature& signature, const Bytes& bytes,
                           const CheckTimes& times) {
  const TrustedKeys::Trusted* signer = trusted_.find(signature.key_id);
  if (!signer)
    return OrderRefusal{Kind::kUntrusted, "it is not signed by a key that this robot trusts"};
  if (const auto of_now = check_times(signature, times); !of_now) return of_now;
  if (!signer->key.verify(bytes(), signature.bytes))
    return OrderRefusal{
        Kind::kBroken,
        "its signature does not fit it: it was changed on the way, or is for another DDS domain"};
  return take_number(signer->id, signature.number);
}

Outcome OrderCheck::take_number(const std::string& key_id, std::uint64_t number) {
  const auto before = before_.find(key_id);
  if (before != before_.end() && number <= before->second)
    return OrderRefusal{Kind::kOfBefore,
                        "it is not newer than orders that this robot carried out before it was "
                        "started again; if it is, its sender's clock was set back: set it right"};
  ReplayWindow& seen = seen_[key_id];
  if (seen.has(number))
    return OrderRefusal{Kind::kReplayed, "it has come before, or is older than orders that have"};
  seen.add(number);
  std::uint64_t& highest = highest_[key_id];
  highest = std::max(highest, number);
  return {};
}

}  // namespace galilean
