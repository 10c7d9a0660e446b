// SPDX-License-Identifier: BSD-3-Clause
// What an instructor can choose from.

import type { SimulationBody, SimulationFault } from "../feed/messages";

export const PIECES = ["can", "cup", "wad"] as const;
const BUMPERS = ["front", "front left", "left", "back left", "back", "back right", "right", "front right"];

/** The parts that can break, by the simulation's names for them, with the operator's. */
export const PARTS: readonly (readonly [part: string, words: string])[] = [
  ["camera", "camera"],
  ["serial_line", "serial line"],
  ["board", "board"],
  ["left_wheel", "left wheel"],
  ["right_wheel", "right wheel"],
  ...BUMPERS.map((where, i) => [`bumper_${i}`, `${where} bumper`] as const),
];

/** How fast simulated time can run. */
export const RATES = [0.25, 0.5, 1, 2, 5, 10, 20];
export const STEPS_S = [0.01, 0.1, 1, 10];

/** Only a bumper can be stuck. */
export const faultsOf = (part: string): readonly string[] => (part.startsWith("bumper") ? ["dead", "stuck"] : ["dead"]);

export function partWords(part: string): string {
  return PARTS.find(([each]) => each === part)?.[1] ?? part;
}

/** "io's front bumper is stuck" */
export function faultWords({ robot, part, fault }: SimulationFault): string {
  return `${robot}'s ${partWords(part)} is ${fault}`;
}

export const ofKind = (bodies: readonly SimulationBody[], kinds: readonly string[]): readonly string[] =>
  bodies.filter(({ kind }) => kinds.includes(kind)).map(({ name }) => name);

/** Where a robot is pushed to, against where it heads. */
export const WAYS = { forward: 0, left: 90, back: 180, right: -90 } as const;
export type Way = keyof typeof WAYS;

/** The direction of a push on the floor. */
export function pushHeading_rad(bodies: readonly SimulationBody[], robot: string, way: Way): number {
  const heading_rad = bodies.find(({ name }) => name === robot)?.heading_rad ?? 0;
  const turned = heading_rad + (WAYS[way] * Math.PI) / 180;
  return Math.atan2(Math.sin(turned), Math.cos(turned));
}
