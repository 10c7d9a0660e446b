// SPDX-License-Identifier: BSD-3-Clause
// Ends what a stage started, so that nothing of it lives on, whatever a fault has done to it.
import { within } from '../../tools/patience.mjs';

/** What does not end in this time when it is asked to is killed. */
const ENDS_WITHIN_MS = 10_000;

/** Waits for the end of a child, for which `ask` asks it first. `closed` is a promise of it. */
export async function endChild(child, closed, ask = () => child.kill('SIGINT')) {
  if (child.exitCode === null && child.signalCode === null) {
    ask();
    child.kill('SIGCONT'); // one that stands still hears of it only then
  }
  try {
    await within(closed, () => `the end of ${child.spawnfile}`, ENDS_WITHIN_MS);
  } catch (late) {
    child.kill('SIGKILL');
    throw late;
  }
}

/** When a child has ended: also one that could not be started. */
export const closeOf = (child) => new Promise((resolve) => child.on('close', resolve).on('error', resolve));
