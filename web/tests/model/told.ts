// SPDX-License-Identifier: BSD-3-Clause
// Messages as a robot tells them, with what a test does not care about filled in.
import { BreakPoint_Constants, type BreakPoint, type Breaks, Breaks_Constants, type MapRobot, type RobotState, type Transition } from "../../src/feed/messages";
import type { BreakKind } from "../../src/feed/parts";
import { emptyTeam, type Robot, type Team } from "../../src/model/model";
import { apply } from "../../src/model/reduce";

export const T0_MS = 1_700_000_000_000;

export function time(ms: number) {
  return { sec: Math.floor(ms / 1000), nsec: Math.round((ms % 1000) * 1e6) };
}

export function state(changes: Partial<RobotState> & { at_ms?: number } = {}): RobotState {
  const { at_ms = T0_MS, ...rest } = changes;
  return {
    stamp: time(at_ms), robot: "io", program_name: "office.bhdl", program_hash: "aaaa", state: "start", state_since: time(at_ms),
    tick: 0n, transitions: 0n, tick_period_s: 0.02, tick_time_us: 5, tick_time_max_us: 8, overruns: 0, held: false,
    in_probation: false, out_of_service: false, x_m: 0, y_m: 0, heading_rad: 0, problems: [], ...rest,
  };
}

export function transition(number: number, to_state: string, at_ms = T0_MS): Transition {
  return {
    stamp: time(at_ms), robot: "io", number: BigInt(number), tick: 0n, from_state: "", to_state, cause: "trash_seen[0] became 1",
    program_hash: "aaaa", file: "office.bhdl", line: 7, bits_variable: "trash_seen", bit_index: 0, bit_value: true, reset_variables: [], tested: [],
  };
}

export const point = (from_state: string, to_state: string, kind: BreakKind = "stop"): BreakPoint =>
  ({ from_state, to_state, kind: BreakPoint_Constants[kind.toUpperCase() as keyof typeof BreakPoint_Constants] });

const NO_POINT = { from_state: "", to_state: "", kind: 0 as BreakPoint_Constants };

export function breaks(changes: Partial<Breaks> & { at_ms?: number } = {}): Breaks {
  const { at_ms = T0_MS, ...rest } = changes;
  return {
    stamp: time(at_ms), robot: "io", points: [], stepping: false, stopped: false, stopped_at: 0n, stopped_by: Breaks_Constants.NOTHING, break_robot: "", break_point: NO_POINT, author: "",
    waits_at_from: "", waits_at_to: "", waits_since: time(0), answers: [], ...rest,
  };
}

export function mapRobot(changes: Partial<MapRobot> = {}): MapRobot {
  const covariance = { variance_xx: 0, variance_xy: 0, variance_yy: 0 };
  return { name: "io", x_m: 0, y_m: 0, heading_rad: 0, age_s: 0, silent: false, ...covariance, ...changes };
}

/** The team after [topic, message, received_ms]…, told to `team`. */
export function told(messages: [string, unknown, number][], team: Team = emptyTeam): Team {
  return messages.reduce((before, [topic, message, at_ms]) => apply(before, topic, message, at_ms), team);
}

export function robotOf(team: Team, name = "io"): Robot {
  const robot = team.robots.get(name);
  if (!robot) throw new Error(`${name} is not in the team`);
  return robot;
}
