// SPDX-License-Identifier: BSD-3-Clause
import { catalogOf } from "../bhdl/catalog";
import type * as wire from "../feed/messages";
import type { News } from "../feed/portions";
import { FILLED, type FollowedParameter, HISTORY_PROBLEM, LEASES, MAP_PROBLEM, REPLAYED, type RobotTopic, robotTopicOf, type TeamTopic } from "../feed/topics";
import { withSeenState, withTransitionCounted } from "./coverage";
import { contestBegan_ms, withEvents } from "./events";
import type { Filled } from "./filled";
import { type Gap, withJoined } from "./gaps";
import { identityOf } from "./identity";
import { type Lease, withLeaseChange } from "./lease";
import type { Robot, Team } from "./model";
import { withMessages } from "./message_rate";
import { withMoment, withVariables } from "./moments";
import { replyOf, withPush, withReply, withStep } from "./pushes";
import { clockOffset_ms, onPageClock_ms, wentBack } from "./robot_clock";
import { withInstruction, withSimulation } from "./simulation";
import { standing } from "./stillness";
import { withBreaks, withoutLater } from "./stops";
import { withBar, withProgram } from "./timeline";
import { unwound, withPoint } from "./trail";
import { withTransition } from "./transitions";

type Reduce<T, M> = (before: T, message: M, received_ms: number) => T;

function robotNamed(team: Team, name: string, received_ms: number): Robot {
  const known = team.robots.get(name);
  if (known) return known;
  const others = [...team.robots.values()].map((robot) => robot.identity);
  const identity = identityOf(name, others);
  return { name, identity, heard_ms: received_ms, transitions: [], moments: new Map(), bars: [], programs: [], events: [], trail: [] };
}

const barOf = (robot: Robot, { number, to_state: state, stamp }: wire.Transition) => ({
  number,
  state,
  from_ms: onPageClock_ms(robot, stamp),
});

/** Until its first state tells what its clock is against the page's, a robot's changes have no place in time. */
function barsBefore(robot: Robot, clocked: Robot): Robot["bars"] {
  if (robot.clock_offset_ms !== undefined) return robot.bars;
  return robot.transitions.reduce((bars, change) => withBar(bars, barOf(clocked, change)), [] as Robot["bars"]);
}

/** Without what its count of changes says has not happened yet, where its time began again. */
function withoutFuture(robot: Robot, { stamp, transitions: count }: wire.RobotState): Robot {
  if (!robot.state || !wentBack(robot.state.value.stamp, stamp)) return robot;
  const transitions = robot.transitions.filter(({ number }) => number <= count);
  const moments = new Map([...robot.moments].filter(([number]) => number <= count));
  return { ...robot, transitions, coverages: new Map(), moments, ...withoutLater(robot, count) };
}

function withState(heard: Robot, value: wire.RobotState, received_ms: number): Robot {
  const robot = withoutFuture(heard, value);
  const clocked = { ...robot, clock_offset_ms: clockOffset_ms(robot.clock_offset_ms, value.stamp, received_ms) };
  const { program_hash: hash, program_name: name } = value;
  return {
    ...clocked,
    state: { value, received_ms },
    standing: standing(robot.standing, value, received_ms),
    coverages: withSeenState(robot.coverages ?? new Map(), value),
    events: withEvents(robot.events, robot.state?.value, value, received_ms, robot.breaks?.value.stopped),
    bars: withBar(barsBefore(robot, clocked), {
      number: value.transitions,
      state: value.state,
      from_ms: onPageClock_ms(clocked, value.state_since),
    }),
    programs: withProgram(robot.programs, { hash, name, at_ms: received_ms }),
  };
}

function withChange(robot: Robot, transition: wire.Transition): Robot {
  const transitions = withTransition(robot.transitions, transition);
  if (transitions === robot.transitions) return robot;
  const moments = withMoment(robot.moments, transition, robot.variables?.value);
  const coverages = withTransitionCounted(robot.coverages ?? new Map(), robot.transitions, transition);
  if (robot.clock_offset_ms === undefined) return { ...robot, transitions, moments, coverages };
  return { ...robot, transitions, moments, coverages, bars: withBar(robot.bars, barOf(robot, transition)) };
}

const ofRobot: { [K in Exclude<RobotTopic, "program_reply">]: Reduce<Robot, never> } = {
  state: withState,
  transition: withChange,
  variables: (robot, value: wire.Variables, received_ms) => ({
    ...robot,
    variables: { value, received_ms },
    moments: withVariables(robot.moments, robot.transitions, value),
  }),
  sightings: (robot, value: wire.Sightings, received_ms) => ({ ...robot, sightings: { value, received_ms } }),
  forces: (robot, value: wire.Forces, received_ms) => ({ ...robot, forces: { value, received_ms } }),
  program: (robot, value: wire.Program, received_ms) => ({ ...robot, program: { value, received_ms } }),
  catalog: (robot, { json }: wire.Catalog) => ({ ...robot, catalog: catalogOf(json) }),
  breaks: withBreaks,
};

function withObjects(team: Team, message: wire.ObjectMap, received_ms: number): Team {
  const robots = new Map(team.robots);
  for (const placed of message.robots) {
    const robot = robotNamed({ ...team, robots }, placed.name, received_ms - placed.age_s * 1000);
    const pose = unwound(robot.pose, placed);
    const trail = withPoint(robot.trail, { x_m: placed.x_m, y_m: placed.y_m, at_ms: received_ms });
    const silences = placed.silent ? [{ from_ms: received_ms - placed.age_s * 1000, to_ms: received_ms }] : [];
    robots.set(placed.name, withSilences({ ...robot, placed, pose, trail }, silences));
  }
  return { ...team, robots, objects: { value: message.objects, received_ms, stamp: message.stamp } };
}

const ofTeam: { [K in TeamTopic | FollowedParameter]: Reduce<Team, never> } = {
  [REPLAYED]: (team, names: readonly string[]) => ({ ...team, replayed: new Set(names) }),
  [HISTORY_PROBLEM]: (team, history_problem: string) => ({ ...team, history_problem }),
  [MAP_PROBLEM]: (team, map_problem: string) => ({ ...team, map_problem }),
  [LEASES]: (team, leases: readonly Lease[]) => ({ ...team, leases }),
  [FILLED]: (team, filled: Filled) => ({ ...team, filled }),
  "/team/lease_change": withLeaseChange,
  "/team/objects": withObjects,
  "/team/map": (team, grid: wire.OccupancyGrid) => ({ ...team, grid }),
  "/team/program_push": (team, push: wire.ProgramPush, received_ms) => ({
    ...team,
    pushes: withPush(team.pushes, push, received_ms),
  }),
  "/team/push_progress": (team, told: wire.PushProgress, received_ms) => ({
    ...team,
    pushes: withStep(team.pushes, told, received_ms),
  }),
  "/referee/score": (team, value: wire.Score, received_ms) => ({
    ...team,
    score: { value, received_ms },
    contest_began_ms: contestBegan_ms(team.contest_began_ms, value, received_ms),
  }),
  "/simulation/state": withSimulation,
  "/simulation/event": (team, event: wire.SimulationEvent, received_ms) => ({
    ...team,
    instructions: withInstruction(team.instructions, event, received_ms),
  }),
};

function withSilences(robot: Robot, silences: readonly Gap[] = []): Robot {
  return silences.length === 0 ? robot : { ...robot, silences: silences.reduce(withJoined, robot.silences ?? []) };
}

/** A message that says something of one robot alone: what it makes of it. */
function robotAfter(team: Team, { topic, message, received_ms, count, pauses }: News): Robot | undefined {
  const named = robotTopicOf(topic);
  const reduce = named && ofRobot[named.kind as keyof typeof ofRobot];
  if (!reduce) return undefined;
  const before = robotNamed(team, named.robot, received_ms);
  const heard = { ...before, heard_ms: Math.max(before.heard_ms, received_ms), rate: withMessages(before.rate, received_ms, count) };
  return withSilences(reduce(heard, message as never, received_ms), pauses);
}

function teamAfter(team: Team, { topic, message, received_ms }: News): Team {
  if (robotTopicOf(topic)?.kind !== "program_reply") return ofTeam[topic as TeamTopic]?.(team, message as never, received_ms) ?? team;
  const reply = message as wire.ProgramReply;
  return { ...team, pushes: withReply(team.pushes, reply.id, replyOf(reply), received_ms) };
}

/** The team after these messages, each the newest of its `count`; the same team where none says anything of it. */
export function applyAll(team: Team, news: readonly News[]): Team {
  /** The robots of `after`, where nobody else has them yet: a hundred robots tell a thousand things in a batch. */
  let own: Map<string, Robot> | undefined;
  let after = team;
  for (const each of news) {
    const robot = robotAfter(after, each);
    if (!robot) {
      after = teamAfter(after, each);
      if (after.robots !== own) own = undefined;
      continue;
    }
    if (!own) after = { ...after, robots: (own = new Map(after.robots)) };
    own.set(robot.name, robot);
  }
  return after;
}

/** The team after one message, the newest of `count`; the same team where the topic says nothing of it. */
export function apply(team: Team, topic: string, message: unknown, received_ms: number, count = 1): Team {
  return applyAll(team, [{ topic, message, received_ms, count }]);
}
