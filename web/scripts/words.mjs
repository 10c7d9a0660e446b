// SPDX-License-Identifier: BSD-3-Clause
// Durations, as performance.mjs tells them.
import { quantile } from "./measures.mjs";

export const ms = (value) => `${value.toFixed(0)} ms`;
export const spread = (all_ms) => `median ${ms(quantile(all_ms, 0.5))}, 99 % ${ms(quantile(all_ms, 0.99))} of ${all_ms.length}`;
