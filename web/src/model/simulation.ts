// SPDX-License-Identifier: BSD-3-Clause
// What a simulation tells of itself: where everything really is, what is broken, and what an instructor ordered.

import type { SimulationBody, SimulationEvent, SimulationState } from "../feed/messages";
import type { Instruction, Robot, Stamped, Team } from "./model";

/** It tells its state ten times a second: one that was not heard for so long is gone. */
const SILENT_MS = 2000;
const KEPT = 64;

export function isThere(simulation: Stamped<SimulationState> | undefined, now_ms: number): simulation is Stamped<SimulationState> {
  return simulation !== undefined && now_ms - simulation.received_ms <= SILENT_MS;
}

/** Where several simulations are heard, the page stays with the one that it heard first. */
export function withSimulation(team: Team, value: SimulationState, received_ms: number): Team {
  const known = team.simulation;
  const isAnother = known !== undefined && known.value.simulation !== value.simulation;
  return isAnother && isThere(known, received_ms) ? team : { ...team, simulation: { value, received_ms } };
}

export function withInstruction(instructions: readonly Instruction[], event: SimulationEvent, at_ms: number): readonly Instruction[] {
  const { order_id: id, author, order, subject, done, text } = event;
  if (instructions.some((each) => each.id === id)) return instructions;
  return [...instructions, { id, author, order, subject, done, text, at_ms }].slice(-KEPT);
}

/** How far a robot believes to be from where it is. */
export interface Discrepancy {
  readonly truth: SimulationBody;
  readonly far_m: number;
}

/** Nothing where nobody tells where the robot is, or where it believes to be. */
export function discrepancyOf({ name, pose }: Robot, bodies: readonly SimulationBody[]): Discrepancy | undefined {
  const truth = bodies.find((body) => body.kind === "robot" && body.name === name);
  return truth && pose && { truth, far_m: Math.hypot(truth.x_m - pose.x_m, truth.y_m - pose.y_m) };
}
