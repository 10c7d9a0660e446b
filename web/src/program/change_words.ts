// SPDX-License-Identifier: BSD-3-Clause
// A line of the monitor's semantic diff: "+ state 'spin'", "- motor schema noise 'wander'", "~ …".

export type Sort = "added" | "removed" | "changed";

export function sortOf(line: string): { sort: Sort; words: string } {
  const sort = line.startsWith("+") ? "added" : line.startsWith("-") ? "removed" : "changed";
  return { sort, words: line.replace(/^[+~-]\s*/, "") };
}
