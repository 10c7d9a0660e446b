// SPDX-License-Identifier: BSD-3-Clause
import { onKey } from "../lib/keys";
import type { Playback } from "../model/playback.svelte";
import { STEP_S } from "./pace";

/** The keys that play a recording, for as long as the page is there. */
export function declareKeys(playback: Playback): void {
  onKey(" ", "play, and stand still", () => playback.toggle());
  onKey(",", "a tenth of a second back, and stand still", () => playback.step(-STEP_S));
  onKey(".", "a tenth of a second on, and stand still", () => playback.step(STEP_S));
}
