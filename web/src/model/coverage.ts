// SPDX-License-Identifier: BSD-3-Clause
// Which states a robot has entered and which conditions have fired, of each program that it ran while the page listened.

import type { MachineTransition, RobotState, Time, Transition } from "../feed/messages";

/** What is known of one program. */
export interface Coverage {
  /** On the robot's clock: the earliest instant of which anything is known. */
  readonly since: Time;
  /** Whether nothing that happened before that instant can be missing. */
  readonly fromStart: boolean;
  /** How often each state was entered; 0: the robot was in it, and nobody saw it enter. */
  readonly entered: ReadonlyMap<string, number>;
  /** How often each condition fired, by `conditionKey`. */
  readonly fired: ReadonlyMap<string, number>;
  /** How many changes of state were never heard of. */
  readonly missed: number;
}

/** By the program's hash. */
export type Coverages = ReadonlyMap<string, Coverage>;

/** As many programs as are remembered: each number that is tuned makes another. */
const KEPT = 8;

/** The same for a condition of a machine and for the transition that it caused. */
export function conditionKey({ from_state, to_state, bits_variable, bit_index, bit_value }: Omit<MachineTransition, "bit_update" | "reset_variables" | "file" | "line">): string {
  return JSON.stringify([from_state, to_state, bits_variable, bit_index, bit_value]);
}

const counted = (counts: ReadonlyMap<string, number>, key: string, by: number): ReadonlyMap<string, number> =>
  new Map(counts).set(key, (counts.get(key) ?? 0) + by);

const isBefore = (a: Time, b: Time): boolean => a.sec < b.sec || (a.sec === b.sec && a.nsec < b.nsec);

function withProgram(all: Coverages, hash: string, coverage: Coverage): Coverages {
  const others = [...all].filter(([known]) => known !== hash).slice(1 - KEPT);
  return new Map([...others, [hash, coverage]]);
}

/** With the state that the robot says it is in: the first that is heard of a program may have been entered long before. */
export function withSeenState(all: Coverages, { program_hash, state, stamp, transitions }: RobotState): Coverages {
  const known = all.get(program_hash);
  if (!program_hash || known?.entered.has(state)) return all;
  const begun = known ?? { since: stamp, fromStart: transitions === 0n, entered: new Map(), fired: new Map(), missed: 0 };
  return withProgram(all, program_hash, { ...begun, entered: counted(begun.entered, state, 0) });
}

/** With a change of state that was not heard before; `earlier` are those that the robot told, without this one. */
export function withTransitionCounted(all: Coverages, earlier: readonly Transition[], next: Transition): Coverages {
  const { program_hash, from_state, to_state, bits_variable, stamp, number } = next;
  const known = all.get(program_hash);
  const isFirst = number === 1n || earlier.some((each) => each.number === number - 1n && each.program_hash !== program_hash);
  const begun = known ?? { since: stamp, fromStart: isFirst, entered: new Map<string, number>(), fired: new Map<string, number>(), missed: 0 };
  // A program that comes by a swap was not in the state that the one before it left.
  const ofItsOwn = bits_variable !== "";
  const from = ofItsOwn && from_state !== "" ? counted(begun.entered, from_state, 0) : begun.entered;
  return withProgram(all, program_hash, {
    since: isBefore(stamp, begun.since) ? stamp : begun.since,
    fromStart: begun.fromStart || (isFirst && (!known || isBefore(stamp, known.since) || [...known.entered.values()].every((times) => times === 0))),
    entered: counted(from, to_state, 1),
    fired: ofItsOwn ? counted(begun.fired, conditionKey(next), 1) : begun.fired,
    missed: Math.max(begun.missed + missedBefore(earlier, next), 0),
  });
}

/** How many more changes are missing than before it; −1: it was missing itself. */
function missedBefore(earlier: readonly Transition[], { number, stamp }: Transition): number {
  const newest = earlier.at(-1);
  if (!newest) return 0;
  if (number > newest.number) return Number(number - newest.number) - 1;
  return stamp.sec > newest.stamp.sec ? Number(number) - 1 : -1;
}
