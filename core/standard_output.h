// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

/// Has the program say in one sentence, when it exits, that its standard output could not be
/// written, as where the disk is full. It then fails, if it would have succeeded. It says nothing
/// where nobody reads any more, as behind `… | head`.
///
/// Standard descriptors that are closed are opened in a way that fails, so that no file that the
/// program opens takes their numbers, and with them what is printed. Call it once, before the
/// program opens or prints anything; more calls change nothing.
void tell_unwritten_output() noexcept;

}  // namespace galilean
