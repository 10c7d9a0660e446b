// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/expect/report/report.h"

namespace galilean::expect {

/// Returns "io: never state is "stuck" for 10 s", with invisible characters as codes.
[[nodiscard]] std::string title(const Verdict& verdict);
/// Returns "office.expect:3:13".
[[nodiscard]] std::string place(const Verdict& verdict);
/// Returns "holds", "fails" or "cannot tell".
[[nodiscard]] std::string word(Outcome outcome);
/// Returns "2.5 s to spare" or "missed by 2.5 s", or an empty text if there is no margin.
[[nodiscard]] std::string margin_text(const Verdict& verdict);
/// Returns a sentence on what did not hold first, or on what is missing, or a note.
[[nodiscard]] std::string explanation(const Verdict& verdict, const Judgement& judgement);
/// Returns how to see the first counterexample: a command that plays the recording from shortly
/// before, if there is one, and the page's address of the instant. Returns an empty text if there
/// is no counterexample.
[[nodiscard]] std::string how_to_see(const Verdict& verdict, const Report& report);
/// Returns the page's address of the first counterexample, "/?robot=io&at=…", or an empty text.
[[nodiscard]] std::string page_address(const Verdict& verdict);
/// Returns the command alone; an empty text if it is about a live team.
[[nodiscard]] std::string replay_command(const Verdict& verdict, const Report& report);
/// Returns "3 hold, 1 does not hold, 1 cannot be told".
[[nodiscard]] std::string totals(const Judgement& judgement);
/// Returns a time since the recording's start, in seconds, as a replay counts it.
[[nodiscard]] double since_begin_s(std::int64_t at_ns, const Judgement& judgement);

}  // namespace galilean::expect
