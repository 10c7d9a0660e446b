// SPDX-License-Identifier: BSD-3-Clause
// The panel's keys that bring it into sight where it is not, and what they do.

export const EVERY_ROBOT = ["v", "what every robot sees, side by side, and back"] as const;
