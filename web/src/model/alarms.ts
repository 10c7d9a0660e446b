// SPDX-License-Identifier: BSD-3-Clause
// What an operator must hear of.

import { ellipseOf } from "./ellipse";
import { drifts, hashesUnderWay, type ProgramShare, programShares } from "./drift";
import { waitOf } from "./breaks";
import { callsOn } from "./events";
import { lasting } from "../lib/format";
import { isAlike } from "../lib/steady";
import { loopOf, repeats } from "./loops";
import type { Robot, Team } from "./model";
import { age_s, isSilent } from "./silence";

export type AlarmKind = "silent" | "overrun" | "drift" | "stuck" | "loop" | "uncertain" | "problem" | "push" | "refused" | "lost";

export interface Alarm {
  /** The same as long as it is the same alarm. */
  readonly key: string;
  readonly kind: AlarmKind;
  /** Of messages that were not taken, the name in their topic, which may be no robot's. */
  readonly robot: string;
  /** One sentence. */
  readonly words: string;
  /** The words once it is over, without how long it lasted; without them the alarm is called over. */
  readonly past?: string;
  /** The words say for how long. */
  readonly timed?: true;
  /** Since when it is so; without it, since it was posted. */
  readonly began_ms?: number;
  /** The words tell of an event, which lasts no time. */
  readonly happened?: true;
  /** What to do about it. */
  readonly advice: string;
}

/** A robot's clock that is further ahead than this is told. */
const CLOCK_AHEAD_MS = 5000;
/** The alarm of a tick that began late stands for so long. */
const OVERRUN_ALARM_MS = 20_000;
/** The alarm of a push that a robot did not take stands for so long, unless the robot answers another before. */
const PUSH_ALARM_MS = 120_000;
/** Whoever neither moves nor turns for so long, though nobody holds it, is stuck. */
const STUCK_AFTER_MS = 20_000;
/** A robot known no better than this, at two standard deviations, is drawn where it may not be. */
const UNCERTAIN_M = 0.8;

type Find = (robot: Robot, now_ms: number, team: Team) => Omit<Alarm, "robot" | "key"> | undefined;

const finders: Record<Exclude<AlarmKind, "silent" | "problem" | "push" | "drift" | "refused" | "lost">, Find> = {
  overrun: ({ name, events, state }, now_ms) => {
    const last = events.filter(({ kind }) => kind === "late").at(-1);
    if (!last || now_ms - last.at_ms > OVERRUN_ALARM_MS) return undefined;
    const words = `${name}'s ticks begin late (${state?.value.overruns} so far).`;
    return { kind: "overrun", words, advice: "Its computer is too slow for this program, or busy with something else." };
  },
  stuck: ({ name, state, program, standing, breaks }, now_ms) => {
    if (!state || !standing || now_ms - standing.since_ms < STUCK_AFTER_MS) return undefined;
    const { held, out_of_service, state: doing } = state.value;
    const waits = doing === program?.value.start_state || waitOf(breaks?.value) !== undefined;
    if (held || out_of_service || waits) return undefined;
    return { kind: "stuck", words: `${name} has not moved for ${Math.round((now_ms - standing.since_ms) / 1000)} s in ${doing}.`, timed: true, advice: "Look whether something holds it, or hold it and lift it free." };
  },
  loop: (robot, now_ms, { score, contest_began_ms }) => {
    if (!robot.state || robot.state.value.held || !repeats(robot.bars, now_ms)) return undefined;
    const deposits_ms = callsOn(robot.name, score, contest_began_ms).filter(({ points }) => points > 0).map(({ at_ms }) => at_ms);
    const order = robot.program?.value.states.map(({ name }) => name) ?? [];
    const loop = loopOf(robot.bars, { deposits_ms, trail: robot.trail }, order, now_ms);
    if (!loop) return undefined;
    const [round, lasted] = [loop.states.join(" → "), lasting((now_ms - loop.from_ms) / 1000)];
    const words = `${robot.name} goes round ${round}, ${loop.rounds} times in ${lasted}.`;
    return { kind: "loop", words, past: `${robot.name} went round ${round}`, timed: true, advice: "Look why nothing comes of it: the Why panel tells each change's cause. Hold it, or lift it free." };
  },
  uncertain: ({ name, placed }) => {
    const radius_m = placed ? ellipseOf(placed).major_m : 0;
    if (!placed || placed.silent || radius_m < UNCERTAIN_M) return undefined;
    return { kind: "uncertain", words: `${name} may be ${radius_m.toFixed(1)} m from where the map shows it.`, advice: "It comes right when it sees objects that others saw, too." };
  },
};

/** What is the same for every robot of a team. */
interface Programs {
  readonly shares: readonly ProgramShare[];
  readonly underWay: ReadonlySet<string>;
}

function ofRobot(robot: Robot, team: Team, { shares, underWay }: Programs, now_ms: number): Alarm[] {
  const of = (kind: AlarmKind, words: string, advice: string, more = ""): Alarm => ({ key: `${kind} ${robot.name} ${more}`, kind, robot: robot.name, words, advice });
  /** A recording that has ended is no trouble, and nobody brings another program to it. */
  const isPlayed = team.replayed.has(robot.name);
  if (isSilent(robot, now_ms)) {
    if (isPlayed) return [];
    const silent = of("silent", `${robot.name} is silent.`, "Check its power and its network; it is shown where it was last heard.");
    return [{ ...silent, past: `${robot.name} was silent`, began_ms: now_ms - age_s(robot, now_ms) * 1000 }];
  }
  const state = robot.state?.value;
  if (state?.out_of_service) return [];
  const found = Object.values(finders).flatMap((find) => find(robot, now_ms, team) ?? []);
  const drift = !isPlayed && drifts(robot, shares, underWay)
    ? [of("drift", `${robot.name} runs ${state?.program_name}, another program than the team.`, "Push the team's program to it, or leave it as a trial.", state?.program_hash)]
    : [];
  const problems = [...(state?.problems ?? []), ...(isPlayed ? [] : clockProblem(robot))].map((problem) => of("problem", `${robot.name}: ${problem}`, "", problem));
  return [...found.map((alarm) => ({ ...alarm, robot: robot.name, key: `${alarm.kind} ${robot.name}` })), ...drift, ...problems];
}

/** Of a robot whose clock is ahead: nothing goes by its stamps, but whoever reads them is misled. */
function clockProblem({ clock_offset_ms = 0 }: Robot): string[] {
  return clock_offset_ms < -CLOCK_AHEAD_MS ? [`its clock is ${Math.round(-clock_offset_ms / 1000)} s ahead`] : [];
}

const inService = (team: Team): Robot[] => [...team.robots.values()].filter(({ name, state }) => !state?.value.out_of_service && !team.replayed.has(name));

export function alarms(team: Team, now_ms: number): Alarm[] {
  const programs = { shares: programShares(inService(team)), underWay: hashesUnderWay(team.pushes, now_ms) };
  return [...[...team.robots.values()].flatMap((robot) => ofRobot(robot, team, programs, now_ms)), ...ofPushes(team, now_ms), ...ofHistory(team), ...ofMap(team)];
}

/** What the monitor tells of its history: pushes may be refused, or what was kept was changed. It is of no robot. */
function ofHistory({ history_problem }: Team): Alarm[] {
  if (!history_problem) return [];
  return [{ key: "history", kind: "problem", robot: "monitor", words: history_problem, advice: "Make room on the monitor's disk, or look with galilean programs verify. Stop, hold and resume go on." }];
}

/** What the monitor tells of its map: where it stands still, what the page shows on it is old. It is of no robot. */
function ofMap({ map_problem }: Team): Alarm[] {
  if (!map_problem) return [];
  return [{ key: "map", kind: "problem", robot: "monitor", words: map_problem, advice: "Do not steer by the map. Look at the monitor's log, and start the monitor again if it goes on." }];
}

/** Those that robots did not take: until they answer a newer one or run it all the same, and not for ever. */
function ofPushes({ pushes, robots }: Team, now_ms: number): Alarm[] {
  return pushes.flatMap((push, i) => {
    const newer = pushes.slice(i + 1);
    const isLeft = (robot: string) => !newer.some(({ replies }) => replies.has(robot)) && robots.get(robot)?.state?.value.program_hash !== push.hash;
    return [...push.replies.values()]
      .filter(({ robot, status }) => (status === "rejected" || status === "rolled_back") && isLeft(robot) && now_ms - push.answered_ms < PUSH_ALARM_MS)
      .map(({ robot, status, message }): Alarm => {
        const words = `${robot} ${status === "rejected" ? "refused" : "went back from"} ${push.name}.`;
        return { key: `push ${push.id} ${robot}`, kind: "push", robot, words, happened: true, advice: message };
      });
  });
}

/** An alarm on the board: it stays until it is over and somebody has seen it. */
export interface PostedAlarm {
  readonly alarm: Alarm;
  readonly since_ms: number;
  readonly over_ms?: number;
  readonly seen: boolean;
}

/** How long a posted alarm has lasted, or lasted until it was over, or how long ago it was, in words: "io is silent, for 12 s". */
export function sentenceOf({ alarm, since_ms, over_ms }: PostedAlarm, now_ms: number): string {
  const words = alarm.words.replace(/\.$/, "");
  if (alarm.happened) return `${words}, ${lasting((now_ms - since_ms) / 1000)} ago`;
  const lasted = lasting(((over_ms ?? now_ms) - (alarm.began_ms ?? since_ms)) / 1000);
  if (over_ms === undefined) return alarm.timed ? words : `${words}, for ${lasted}`;
  return alarm.past ? `${alarm.past} for ${lasted}` : `${words}; over after ${lasted}`;
}

/** What was over sooner was none: a page that has just been opened hears one robot before the other. */
const PASSING_MS = 1500;

/** The board with what is wrong now; one that comes again after it was over is a new one. The same board where nothing changed. */
export function withAlarms(board: readonly PostedAlarm[], active: readonly Alarm[], now_ms: number): readonly PostedAlarm[] {
  const known = new Map(board.map((posted) => [posted.alarm.key, posted]));
  const now = new Set(active.map(({ key }) => key));
  const ended = board
    .filter(({ alarm, since_ms, over_ms }) => !now.has(alarm.key) && (over_ms ?? now_ms) - since_ms >= PASSING_MS)
    .map((posted): PostedAlarm => (posted.over_ms === undefined ? { ...posted, over_ms: now_ms } : posted));
  const stands = active.map((alarm): PostedAlarm => {
    const before = known.get(alarm.key);
    if (!before || before.over_ms !== undefined) return { alarm, since_ms: now_ms, seen: false };
    const same = alarm.began_ms === undefined ? alarm : { ...alarm, began_ms: before.alarm.began_ms };
    return isAlike(before.alarm, same) ? before : { ...before, alarm: same };
  });
  const next = [...stands, ...ended.filter(({ seen }) => !seen)].sort((a, b) => Number(a.seen) - Number(b.seen) || b.since_ms - a.since_ms);
  return next.length === board.length && next.every((posted, i) => posted === board[i]) ? board : next;
}

/** The board after somebody has seen the alarms with these keys, or all of them. */
export function acknowledged(board: readonly PostedAlarm[], keys?: readonly string[]): readonly PostedAlarm[] {
  return board.map((posted) => (keys === undefined || keys.includes(posted.alarm.key) ? { ...posted, seen: true } : posted)).filter(({ seen, over_ms }) => !(seen && over_ms !== undefined));
}

/** The board as it was at an instant: without what was posted later, and with what was over later. */
export function boardAt(board: readonly PostedAlarm[], at_ms: number): readonly PostedAlarm[] {
  return board.filter(({ since_ms }) => since_ms <= at_ms).map(({ over_ms, ...posted }) => (over_ms !== undefined && over_ms <= at_ms ? { ...posted, over_ms } : posted));
}
