// SPDX-License-Identifier: BSD-3-Clause
// What performance.mjs tells of the page of one team, a row each.
import { changesToPixels_ms, frames, keysToStops, memory, quantile } from "./measures.mjs";
import { bring } from "./scenes.mjs";
import { ms, spread } from "./words.mjs";

const STOPS = 9;
/** By the number of robots. */
const WANTED = {
  frames: { 3: "60", 30: "60", 100: "30" },
  change: { 3: "20 ms, 50 ms", 30: "99 % ≤ 100 ms", 100: "99 % ≤ 250 ms" },
};

/** `isPlayed`: the team may be told to stop. `seconds`, `changes` and `minutes` are those of performance.mjs. */
export async function addPageRows(rows, page, { robots, rate, isPlayed, seconds, changes, minutes }) {
  const of = `${robots} ${robots === 1 ? "robot" : "robots"}`;
  await rows.add(`${of}: frames a second`, WANTED.frames[robots] ?? "", async () => {
    const { gaps_ms, busy } = await frames(page, Number(seconds));
    const total_s = gaps_ms.reduce((sum, gap_ms) => sum + gap_ms, 0) / 1000;
    return `${(gaps_ms.length / total_s).toFixed(0)}; 99 % within ${ms(quantile(gaps_ms, 0.99))}; main thread busy ${(busy * 100).toFixed(0)} %`;
  });
  if (isPlayed) {
    const keys = keysToStops(page, { times: STOPS, rate });
    await rows.add(`${of}: key to STOP sent`, "", async () => spread((await keys).keepingUp_ms));
    await rows.add(`${of}: key to STOP sent, while the page catches up`, "", async () => spread((await keys).catchingUp_ms));
  }
  await rows.add(`${of}: change of state to pixel`, WANTED.change[robots] ?? "", async () => {
    if (rate > 1) await bring(page, "why");
    const delays_ms = await changesToPixels_ms(page, Number(changes));
    if (delays_ms.length === 0) throw new Error("no change of state came");
    return spread(delays_ms);
  });
  if (Number(minutes) > 0) await rows.add(`${of}: memory over ${minutes} min`, "", async () => {
    const { samples, more_MB_per_h } = await memory(page, Number(minutes));
    const more = more_MB_per_h === undefined ? "" : `; ${more_MB_per_h.toFixed(1)} MB more an hour once its ten minutes are full`;
    return `${samples.map(({ MB }) => MB.toFixed(1)).join(" ")} MB${more}`;
  });
}
