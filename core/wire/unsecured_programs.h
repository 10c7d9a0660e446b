// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/wire/entity.h"

namespace galilean::wire {

/// Tells once of each program without keys that is in the domain of a secured participant, by the
/// name and the address that it announces. Cyclone keeps it out by itself, but names it by numbers
/// alone, in lines that it does not end. Returns what has to be kept for as long as it is to tell.
/// Requires: the participant is secured, and outlives what is returned.
[[nodiscard]] Entity tell_of_unsecured_programs(std::int32_t participant);

}  // namespace galilean::wire
