// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wire/messages.h"
#include "monitor/server/text/request_fields.h"

namespace galilean::monitor {

/// Reads an order about break points: {targets, author, order, points: [{from, to, kind}]}. The
/// objection of `fields` says what is wrong with it. The order has neither id nor stamp yet.
[[nodiscard]] msg::BreakOrder break_order(RequestFields& fields);

}  // namespace galilean::monitor
