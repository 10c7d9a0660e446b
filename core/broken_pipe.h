// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

/// Makes writes to a pipe or socket that nobody reads any more fail with EPIPE. Otherwise SIGPIPE
/// would end the process. It is for programs that do more than print: a robot that drives must
/// outlive whoever reads its log. A program that only prints does not call it, so that `… | head`
/// ends it quietly.
void ignore_broken_pipes() noexcept;

/// Makes writes beyond the limit of `ulimit -f` fail with EFBIG, which can be told. Otherwise
/// SIGXFSZ would end the process.
void ignore_file_size_limit() noexcept;

}  // namespace galilean
