// SPDX-License-Identifier: BSD-3-Clause
// The panel's keys that bring it into sight where it is not, and what they do.

export const COVERAGE = ["o", "show what has happened at all, on the state machine"] as const;
export const BREAK = ["b", "break point: stop where the state machine is pointed at, or no more"] as const;
export const BREAKS = ["B", "list of break points; while it is open, a click on the state machine sets one"] as const;
