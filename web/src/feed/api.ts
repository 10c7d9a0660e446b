// SPDX-License-Identifier: BSD-3-Clause
// The monitor's HTTP operations. Every failure is an Error whose message can be shown as it stands.

import type { Command_Constants, Diagnostic, ProgramReply, PushStep, SourceFile } from "./messages";
import type { BreakKind, Machine, StateChange } from "./parts";
import { RECORDED, recording } from "./recording";
import { credentials } from "./token";
import { introduction, newId } from "./who";

/** What a robot answers to a push; `latency_ms` where the monitor measured it. */
export type Reply = Pick<
  ProgramReply,
  "robot" | "hash" | "running_hash" | "message" | "swap_tick_us" | "kept_variables" | "diagnostics"
> & { readonly status: string; readonly latency_ms?: number };

export interface ProgramEntry {
  name: string;
  source: string;
  hash?: string;
}

export interface CheckResult {
  ok: boolean;
  hash: string;
  diagnostics: Diagnostic[];
  /** Files that were not sent, and that the monitor took from its programs. */
  taken?: { path: string; from: string }[];
  machine?: Machine;
  /** What it tells robots otherwise than what it was checked against, in words. */
  changes?: string[];
}

/** The mean of several simulated runs, and its standard deviation. */
export interface Figure {
  mean: number;
  spread: number;
}

export interface TrialSide {
  score: Figure;
  deposited: Figure;
  collisions: Figure;
  seconds_in_state: Record<string, Figure>;
}

/** The new program beside the one that runs, if one does. */
export interface Trial {
  runs: number;
  duration_s: number;
  now: TrialSide | null;
  next: TrialSide;
}

export interface PushResult {
  id: string;
  hash: string;
  state: string;
  steps: PushStep[];
  trial: Trial | null;
  replies: Reply[];
  /** Why the monitor's history does not hold all of this yet. */
  not_kept?: string;
}

/** The way that a program takes to its robots. */
export interface PushWay {
  tries?: boolean;
  /** The robot that runs it first; empty: all at once. */
  canary?: string;
  probation_s?: number;
  /** Refuse where another program than this runs. */
  replaces?: string;
  /** Why, in a few words; it stands in the history beside who pushed it. */
  reason?: string;
}

/** A program that somebody pushed before, by the hash that tells it from others of its name. */
export interface PushedProgram {
  program: string;
  hash: string;
  author: string;
  pushed_ns: number;
  id: string;
  targets: string[];
  state?: string;
  steps?: PushStep[];
  /** When its robots told that they run it, if that was after it had ended; else 0. */
  told_ns?: number;
}

/** What the monitor objects to; of a program, with every place. */
export class Refusal extends Error {
  constructor(
    message: string,
    readonly diagnostics: readonly Diagnostic[] = [],
  ) {
    super(message);
  }
}

/** No answer came: the monitor may have done what it was asked for, or not. */
class Unanswered extends Refusal {}
/** The monitor cannot do it now, nor look an earlier order up. */
class Unavailable extends Refusal {}

interface Problem {
  title?: string;
  detail?: string;
  diagnostics?: Diagnostic[];
}

export type CommandKind = Lowercase<keyof typeof Command_Constants>;

async function call<T>(path: string, body?: unknown, keepalive = false): Promise<T> {
  const headers = { ...credentials(), ...introduction(), "content-type": "application/json" };
  const request: RequestInit = body === undefined ? { headers } : { method: "POST", headers, body: JSON.stringify(body), ...(keepalive && { keepalive }) };
  let response: Response;
  try {
    response = await fetch(path, request);
  } catch {
    throw new Unanswered("The monitor does not answer.");
  }
  if (response.ok) return (await response.json()) as T;
  const problem = (await response.json().catch(() => ({}))) as Problem;
  const sentence = problem.detail || problem.title || `The monitor answered ${response.status}.`;
  throw new (response.status === 503 ? Unavailable : Refusal)(sentence, problem.diagnostics);
}

/** What robots or a simulation are told. A page that shows a recording tells the live team nothing. */
function order<T>(path: string, body: unknown): Promise<T> {
  return recording === undefined ? call(path, body) : Promise.reject(new Refusal(RECORDED));
}

export async function listPrograms(): Promise<ProgramEntry[]> {
  return (await call<{ programs: ProgramEntry[] }>("/api/programs")).programs;
}

export async function readProgram(name: string): Promise<SourceFile[]> {
  const path = `/api/programs/${name.split("/").map(encodeURIComponent).join("/")}`;
  return (await call<{ files: SourceFile[] }>(path)).files;
}

/** How a program fared in this contest, over all robots that ran it. */
export interface Strategy {
  program_name: string;
  program_hash: string;
  robot_seconds: number;
  deposited: number;
  collisions: number;
  points: number;
}

export async function listStrategies(): Promise<Strategy[]> {
  return (await call<{ strategies: Strategy[] }>("/api/strategies")).strategies;
}

export async function listPushed(): Promise<PushedProgram[]> {
  return (await call<{ pushes: PushedProgram[] }>("/api/pushes")).pushes;
}

export async function readPushed(hash: string): Promise<SourceFile[]> {
  return (await call<{ files: SourceFile[] }>(`/api/pushed/${hash}`)).files;
}

/** `against`: a program, such as the one that runs, to tell what is different. */
export function check(files: readonly SourceFile[], robot?: string, against?: readonly SourceFile[]): Promise<CheckResult> {
  return call("/api/check", { files, ...(robot && { robot }), ...(against && { against }) });
}

/** How often a push whose answer was lost is sent again, and how long after. A monitor starts again in less. */
const REPEATS = 10;
const REPEAT_EACH_MS = 1000;

const pause = (wait_ms: number): Promise<void> => new Promise((resolve) => void setTimeout(resolve, wait_ms));

/** Sends a push until it is answered. It has an id, by which the monitor knows it again: however often it comes, it is one push. */
async function orderPush(body: unknown): Promise<PushResult> {
  for (let repeat = 0; ; repeat += 1) {
    try {
      return await order<PushResult>("/api/push", body);
    } catch (error) {
      const isUnknown = error instanceof Unanswered || (error instanceof Unavailable && repeat > 0);
      if (!isUnknown) throw error;
      if (repeat === REPEATS) throw new Refusal("The monitor does not answer. Whether the program was pushed is not known; the history of pushes tells it once the monitor answers.");
      await pause(REPEAT_EACH_MS);
    }
  }
}

/** Empty `targets` mean the whole team. */
export function push(files: readonly SourceFile[], targets: readonly string[], way: PushWay = {}): Promise<PushResult> {
  const { tries, reason, ...rest } = way;
  const author = reason ? `operator (${reason})` : "operator";
  return orderPush({ id: newId(), files, targets, author, try: tries ?? false, ...rest });
}

export function readPush(id: string): Promise<PushResult> {
  return call(`/api/pushes/${id}`);
}

export function cancelPush(id: string): Promise<PushResult> {
  return order(`/api/pushes/${id}/cancel`, { author: "operator" });
}

export function command(kind: CommandKind, targets: readonly string[], argument = 0): Promise<{ id: string }> {
  return order("/api/command", { kind, targets, argument });
}

export type BreakOrderKind = "set" | "remove" | "clear" | "let_through";

/** Empty `targets` mean the whole team. Each robot answers with the id in its breaks. */
export function orderBreaks(kind: BreakOrderKind, targets: readonly string[], points: readonly (StateChange & { readonly kind?: BreakKind })[] = []): Promise<{ id: string }> {
  return order("/api/breaks", { order: kind, targets, author: "operator", ...(points.length > 0 && { points }) });
}

/** An instructor's order to a simulation, as docs/openapi.yaml describes it. */
export interface SimulationOrder {
  readonly order: string;
  readonly subject?: string;
  readonly part?: string;
  readonly fault?: string;
  readonly x_m?: number;
  readonly y_m?: number;
  readonly heading_rad?: number;
  readonly impulse_ns?: number;
  readonly duration_s?: number;
  readonly rate?: number;
}

/** Returns what the simulation did; what it refuses is a Refusal with its reason. */
export function orderSimulation(simulation: string, what: SimulationOrder): Promise<{ text: string }> {
  return order("/api/simulation/orders", { ...what, simulation, author: "operator" });
}

export type LeaseDeed = "ask" | "give" | "refuse" | "take" | "release";

/** No `robots`, of a release: all that the page's operator holds or asks for. `leaving`: the page is about to be closed. */
export function changeLease(deed: LeaseDeed, robots: readonly string[], reason?: string, leaving = false): Promise<unknown> {
  const body = { do: deed, robots, ...(reason && { reason }) };
  return recording === undefined ? call("/api/lease", body, leaving) : Promise.reject(new Refusal(RECORDED));
}

/** Messages on a topic that the monitor did not take, for one reason. */
export interface RefusedMessages {
  /** As on DDS, such as rt/io/state; "(others)" for what is not told apart. */
  readonly topic: string;
  readonly reason: string;
  readonly messages: number;
}

/** Of a topic that the monitor reads, what the page uses. */
export interface ChannelIntake {
  /** As on DDS, such as rt/io/transition. */
  readonly topic: string;
  /** Events of a robot that will not come, because it does not keep them any more. */
  readonly lost: number;
}

/** Of GET /api/status what the page uses, as docs/openapi.yaml describes it. */
export interface Status {
  readonly name: string;
  readonly scenario: string;
  readonly version: string;
  /** Whether the token that the page has gives the right to. */
  readonly may_steer: boolean;
  /** Who the page's operator is, if it may steer. */
  readonly operator?: { name: string; account: string } | null;
  readonly channels?: readonly ChannelIntake[];
  readonly refused_messages: readonly RefusedMessages[];
  /** Topics beyond those that the monitor reads. */
  readonly topics_not_read: number;
}

export function status(): Promise<Status> {
  return call("/api/status");
}

/** A file that can be shown, as docs/openapi.yaml describes it. */
export interface Recording {
  readonly name: string;
  readonly bytes: number;
  /** When the file was written last. */
  readonly modified: string;
  /** Of its first and last message, in ns since the epoch. */
  readonly start: number;
  readonly end: number;
  readonly messages: number;
  readonly robots: readonly string[];
  /** It was closed as it should be: nothing of its end is missing. */
  readonly complete: boolean;
  /** Why it cannot be opened. */
  readonly why?: string;
}

/** The newest first, and the folder of the monitor's machine in which they lie. */
export function listRecordings(): Promise<{ folder: string; recordings: Recording[] }> {
  return call("/api/recordings");
}

/** What all robots that ran one program did of it in a recording. */
export interface RecordedProgram {
  readonly hash: string;
  readonly name: string;
  /** The recording tells what the program has. */
  readonly described: boolean;
  /** Visited and entered 0 times: a robot was in it, and was not seen to enter it. */
  readonly states: readonly { readonly name: string; readonly visited: boolean; readonly entered: number }[];
  readonly conditions: readonly {
    readonly from: string;
    readonly to: string;
    readonly file: string;
    readonly line: number;
    readonly bits_variable: string;
    readonly bit_index: number;
    readonly bit_value: boolean;
    readonly taken: number;
    /** How often it held while one before it was taken. */
    readonly held_behind_another: number;
  }[];
}

export interface RecordedCoverage {
  readonly programs: readonly RecordedProgram[];
  /** What could not be counted, in clauses. */
  readonly uncounted: readonly string[];
}

/** The monitor reads the whole recording for it, which may take some seconds. */
export function readCoverage(name: string): Promise<RecordedCoverage> {
  return call(`/api/recordings/${encodeURIComponent(name)}/coverage`);
}
