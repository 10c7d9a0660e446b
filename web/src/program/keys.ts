// SPDX-License-Identifier: BSD-3-Clause
// The panel's keys that bring it into sight where it is not, and what they do.

export const EDIT = ["e", "edit a program"] as const;
