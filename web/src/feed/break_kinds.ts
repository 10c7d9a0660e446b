// SPDX-License-Identifier: BSD-3-Clause
// What a break point does: a number on the wire, and a name in orders over HTTP.

import { type BreakPoint, BreakPoint_Constants } from "./messages";
import { type BreakKind, namesOf } from "./parts";

const NAMES = namesOf(BreakPoint_Constants);

/** What a robot's break point does; undefined: this release does not know it. */
export const kindOf = ({ kind }: BreakPoint): BreakKind | undefined => NAMES[kind];
