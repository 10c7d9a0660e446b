// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

/// Has the process write one sentence to stderr before it ends by a fault: by an exception that
/// nobody catches, also where no memory is left, or because a library aborts it. `program` is the
/// name that stands before the sentence, and must live as long as the process. An end without
/// memory is exit code 1; another one is SIGABRT, as without this.
void say_why_it_ends(const char* program) noexcept;

}  // namespace galilean
