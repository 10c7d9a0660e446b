// SPDX-License-Identifier: BSD-3-Clause
// What of a robot's program has happened in the whole recording that the page shows, also behind the instant that is
// shown, as the monitor counts it.

import { readCoverage, type RecordedCoverage, type RecordedProgram } from "../feed/api";
import type { Program } from "../feed/messages";
import { Attempts } from "../lib/attempts.svelte";
import { Latest } from "../lib/latest";
import { conditionKey } from "../model/coverage";
import { arrowCounts, type MachineCoverage, shares, stateCounts } from "./machine_coverage";

/** Without counts where nothing is known yet, and the sentence says why. */
export type ToldCoverage = Pick<MachineCoverage, "sentence"> & Partial<MachineCoverage>;

/** Of the program, whichever robots of the recording ran it. */
export function recordedCoverageOf(program: Program, { programs, uncounted }: RecordedCoverage): ToldCoverage {
  const missing = uncounted.length > 0 ? uncounted.join("; ") : undefined;
  const recorded = programs.find(({ hash, described }) => described && hash === program.hash);
  if (!recorded) return { sentence: `It cannot be told what has happened of this program in the whole of this recording${missing ? `: ${missing}` : ""}.` };
  const entered = new Map(recorded.states.filter(({ visited }) => visited).map((state) => [state.name, state.entered]));
  const fired = firedIn(recorded);
  const counts = { states: stateCounts(program, { entered }), arrows: arrowCounts(program, fired) };
  const sentence = `${shares(program, counts, fired)} have happened in the whole of this recording, whichever robot ran this program.`;
  return { counts, fired, sentence: missing ? `${sentence} It may be more: ${missing}.` : sentence };
}

/** By the page's keys: two lines of a program may have the same condition. */
function firedIn({ conditions }: RecordedProgram): Map<string, number> {
  const fired = new Map<string, number>();
  for (const { from, to, bits_variable, bit_index, bit_value, taken } of conditions) {
    const key = conditionKey({ from_state: from, to_state: to, bits_variable, bit_index, bit_value });
    fired.set(key, (fired.get(key) ?? 0) + taken);
  }
  return fired;
}

class Recorded {
  readonly #attempts = new Attempts();
  readonly #asked = new Latest();
  #counted = $state.raw<RecordedCoverage>();

  /** Asks the monitor. What it told before is shown until it answers: it may have been counted while the recording was written. */
  async count(recording: string): Promise<void> {
    const sentence = ({ message }: Error) => `What has happened in the whole of this recording cannot be counted: ${message.replace(/\.$/, "")}; switch Coverage off and on to try again.`;
    await this.#attempts.make(() => this.#asked.take(readCoverage(recording), (counted) => (this.#counted = counted)), sentence);
  }

  of(program: Program): ToldCoverage {
    if (this.#attempts.failure !== undefined) return { sentence: this.#attempts.failure };
    if (!this.#counted) return { sentence: "What has happened in the whole of this recording is being counted…" };
    return recordedCoverageOf(program, this.#counted);
  }
}

export const recorded = new Recorded();
