// SPDX-License-Identifier: BSD-3-Clause
// What a soak's log ends with.

const MB = 1 << 20;

/** The account of what was made of each fault. */
export class Outcomes {
  #byFault = new Map();

  /** Notes that all was well again after so many seconds; undefined: it was not. */
  note(fault, well_after_s) {
    const known = this.#byFault.get(fault) ?? { made: 0, wrong: 0, worst_s: 0 };
    known.made += 1;
    if (well_after_s === undefined) known.wrong += 1;
    else known.worst_s = Math.max(known.worst_s, well_after_s);
    this.#byFault.set(fault, known);
  }

  /** A line for each fault. */
  lines() {
    return [...this.#byFault].map(([fault, { made, wrong, worst_s }]) =>
      `fault: ${fault}: made ${made} times, ${wrong} of them wrong, well again after ${worst_s.toFixed(1)} s at most`);
  }
}

/** A line on the memory of a process, as judgeMemory sees it. */
export function memoryLine(name, judged) {
  if (!judged) return `memory of ${name}: too few samples`;
  const { flat, first_bytes, last_bytes, bytes_per_hour } = judged;
  return `memory of ${name}: ${(first_bytes / MB).toFixed(1)} MB at first, ${(last_bytes / MB).toFixed(1)} MB at last, ` +
    `${(bytes_per_hour / MB).toFixed(2)} MB more an hour${flat ? '' : ': it grows'}`;
}

/** How many messages a recorder says that it recorded, and lost: of its own words. */
export function recordedOf(words) {
  const sum = (pattern) => [...words.matchAll(pattern)].reduce((total, [, count]) => total + Number(count), 0);
  return { recorded: sum(/: (\d+) messages? of \d+ topics? in /g), lost: sum(/ (?:lost|lacks, for want of room on the disk,) (\d+) of /g) };
}

const COUNTED = /^(galilean_(?:refused_messages|limit_reached|topics_not_read|websocket_superseded|websocket_dismissed|out_of_memory|strategies_dropped|http_malformed)_total)(?:\{[^}]*\})? (\d+)$/gm;

/** What the monitor refused and dropped, by the counter's name, as its metrics tell. Zeros are left out. */
export function countedOf(metrics) {
  const counted = new Map();
  for (const [, name, count] of metrics.matchAll(COUNTED)) if (Number(count) > 0) counted.set(name, (counted.get(name) ?? 0) + Number(count));
  return counted;
}
