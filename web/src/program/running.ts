// SPDX-License-Identifier: BSD-3-Clause
// What the robots of a push run now. Empty `targets` mean the whole team.

import type { Program } from "../feed/messages";
import { live } from "../model/live.svelte";

function robotsOf(targets: readonly string[]): readonly string[] {
  return targets.length ? targets : [...live.present.robots.keys()];
}

export function runningProgram(targets: readonly string[]): Program | undefined {
  return live.present.robots.get(robotsOf(targets)[0] ?? "")?.program?.value;
}

/** What all of them run; empty where they differ: then no one program is replaced. */
export function runningHash(targets: readonly string[]): string {
  const hashes = new Set(robotsOf(targets).map((name) => live.present.robots.get(name)?.state?.value.program_hash));
  return hashes.size === 1 ? ([...hashes][0] ?? "") : "";
}
