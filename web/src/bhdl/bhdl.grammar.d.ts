// SPDX-License-Identifier: BSD-3-Clause
import type { LRParser } from "@lezer/lr";

export const parser: LRParser;
