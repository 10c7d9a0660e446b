// SPDX-License-Identifier: BSD-3-Clause
// Whether the memory of processes stays as it is: the line of least squares through samples of it.
import { readFileSync } from 'node:fs';

/** The beginning of a run does not count: what is needed is not all there yet. */
const SETTLING_SHARE = 0.2;
/** A line that rises by less in a whole run is flat: by a share of the memory, or by so much. */
const FLAT_SHARE = 0.03, FLAT_BYTES = 3 << 20;
/** Fewer samples tell nothing. */
const LEAST_SAMPLES = 10;
const PAGE_BYTES = 4096;

/** The memory that a process has in RAM [bytes]; undefined if it has ended. */
export function memoryOf(pid) {
  try {
    return PAGE_BYTES * Number(readFileSync(`/proc/${pid}/statm`, 'utf8').split(' ')[1]);
  } catch { return undefined; }
}

/** The line through [x, y]: { slope, at(x) }. */
export function lineThrough(points) {
  const mean = (values) => values.reduce((sum, each) => sum + each, 0) / values.length;
  const [x, y] = [mean(points.map((each) => each[0])), mean(points.map((each) => each[1]))];
  const spread = points.reduce((sum, [at]) => sum + (at - x) ** 2, 0);
  const slope = spread > 0 ? points.reduce((sum, [at, value]) => sum + (at - x) * (value - y), 0) / spread : 0;
  return { slope, at: (place) => y + slope * (place - x) };
}

/**
 * Judges samples [time in s, bytes], the oldest first: { flat, mean_bytes, first_bytes, last_bytes, growth_bytes, bytes_per_hour },
 * where the first one is behind the beginning; or undefined: too few.
 */
export function judgeMemory(samples) {
  const settled = samples.slice(Math.ceil(SETTLING_SHARE * samples.length));
  if (settled.length < LEAST_SAMPLES) return undefined;
  const line = lineThrough(settled), [begin, end] = [settled[0][0], settled.at(-1)[0]];
  const mean_bytes = line.at((begin + end) / 2), growth_bytes = line.slope * (end - begin);
  const flat = growth_bytes <= Math.max(FLAT_SHARE * mean_bytes, FLAT_BYTES);
  return { flat, mean_bytes, first_bytes: settled[0][1], last_bytes: settled.at(-1)[1], growth_bytes, bytes_per_hour: 3600 * line.slope };
}
