// SPDX-License-Identifier: BSD-3-Clause
// What the page knows of the team. Plain values, never changed in place: a new one replaces the old,
// so that an instant can be kept whole at little cost. Times in ms are the page's clock.

import type {
  Breaks,
  Forces,
  MapObject,
  MapRobot,
  OccupancyGrid,
  Program,
  PushStep,
  RobotState,
  Score,
  Sightings,
  SimulationEvent,
  SimulationState,
  Time,
  Transition,
  Variables,
} from "../feed/messages";
import type { Catalog } from "../bhdl/catalog";
import type { Reply } from "../feed/api";
import type { Coverages } from "./coverage";
import type { RobotEvent } from "./events";
import type { Filled } from "./filled";
import type { Gap } from "./gaps";
import type { Identity } from "./identity";
import type { Lease } from "./lease";
import type { MessageRate } from "./message_rate";
import type { Standing } from "./stillness";

export interface Stamped<T> {
  readonly value: T;
  readonly received_ms: number;
}

export interface TrailPoint {
  readonly x_m: number;
  readonly y_m: number;
  readonly at_ms: number;
}

/** A robot in the team's frame; `heading_rad` runs on past ±π, so that drawing never spins it round. */
export interface Pose {
  readonly x_m: number;
  readonly y_m: number;
  readonly heading_rad: number;
}

/** One state's stay: until the next bar begins, or until now. */
export interface StateBar {
  /** How many changes of state the robot had made when it began. */
  readonly number: bigint;
  readonly state: string;
  readonly from_ms: number;
}

/** Another program began to run. */
export interface ProgramChange {
  readonly hash: string;
  readonly name: string;
  readonly at_ms: number;
}

/** A robot's variables around one change of state. */
export interface Moment {
  /** Told before the change. */
  readonly before?: Variables;
  /** Told at its tick or just after it. */
  readonly after?: Variables;
}

/** What stopped a robot at one of its changes of state. */
export interface Stop {
  /** Of the robot's clock, in seconds: at the change or after it. */
  readonly told_s: number;
  /** "break point wander → grab, set by operator" */
  readonly by: string;
}

export interface Robot {
  readonly name: string;
  readonly identity: Identity;
  readonly heard_ms: number;
  /**
   * Since when the page, itself up to date, listens to it on this connection; Infinity: it is not up to date yet. Without it
   * the robot was listened to at any time.
   */
  readonly watched_ms?: number;
  /** Add it to a stamp of this robot to have the page's clock. */
  readonly clock_offset_ms?: number;
  readonly state?: Stamped<RobotState>;
  readonly variables?: Stamped<Variables>;
  readonly sightings?: Stamped<Sightings>;
  /** Told only while somebody looks at them. */
  readonly forces?: Stamped<Forces>;
  readonly program?: Stamped<Program>;
  /** What its programs may name, and what that is to the page. */
  readonly catalog?: Catalog;
  /** Where it stops, and why it stands. */
  readonly breaks?: Stamped<Breaks>;
  /** By the number of the transition, of those that stopped it while the page listened. */
  readonly stops?: ReadonlyMap<bigint, Stop>;
  readonly transitions: readonly Transition[];
  /** By the number of the transition, of those that happened while the page listened. */
  readonly moments: ReadonlyMap<bigint, Moment>;
  /** What has happened at all, of each program. */
  readonly coverages?: Coverages;
  readonly bars: readonly StateBar[];
  /** When it was not heard, as far as that is over or the monitor told of it: what it did then is not known. */
  readonly silences?: readonly Gap[];
  readonly programs: readonly ProgramChange[];
  readonly events: readonly RobotEvent[];
  readonly standing?: Standing;
  readonly rate?: MessageRate;
  readonly placed?: MapRobot;
  readonly pose?: Pose;
  readonly trail: readonly TrailPoint[];
}

/** A push of a program, by whomever, and each robot's newest answer to it. */
export interface Push {
  readonly id: string;
  readonly author: string;
  readonly name: string;
  readonly hash: string;
  readonly targets: readonly string[];
  readonly at_ms: number;
  readonly replies: ReadonlyMap<string, Reply>;
  /** When a robot answered last; before that, when it was pushed. */
  readonly answered_ms: number;
  /** running, done, failed, cancelled or interrupted; empty: it did not go through the monitor. */
  readonly state: string;
  readonly steps: readonly PushStep[];
}

/** What became of an instructor's order to the simulation. */
export interface Instruction extends Pick<SimulationEvent, "author" | "order" | "subject" | "done" | "text"> {
  readonly id: string;
  readonly at_ms: number;
}

export interface Team {
  readonly robots: ReadonlyMap<string, Robot>;
  /** The names of those that a recording plays among the live ones: they are not there, and take no orders. */
  readonly replayed: ReadonlySet<string>;
  /** What is wrong with the monitor's history, in one sentence; empty or not there where nothing is known to be. */
  readonly history_problem?: string;
  /** What is wrong with the monitor's map, in the same way. */
  readonly map_problem?: string;
  /** Which changes of state fill a gap; undefined where the monitor tells nothing of it. */
  readonly filled?: Filled;
  /** With the map's own time, which its objects' `last_seen` keeps. */
  readonly objects?: Stamped<readonly MapObject[]> & { readonly stamp: Time };
  readonly grid?: OccupancyGrid;
  readonly score?: Stamped<Score>;
  readonly contest_began_ms?: number;
  readonly pushes: readonly Push[];
  /** Where everything really is, where a simulation tells it. */
  readonly simulation?: Stamped<SimulationState>;
  readonly instructions: readonly Instruction[];
  /** The robots that somebody steers; undefined where the monitor tells nothing of it. */
  readonly leases?: readonly Lease[];
}

export const emptyTeam: Team = { robots: new Map(), replayed: new Set(), pushes: [], instructions: [] };
