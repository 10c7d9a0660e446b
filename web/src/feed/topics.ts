// SPDX-License-Identifier: BSD-3-Clause
// Which topics the page knows, and what a topic's name says.

export const robotTopics = ["state", "transition", "variables", "sightings", "program", "program_reply", "catalog", "breaks"] as const;
/** Read only while a panel shows them. */
export const watchedTopics = ["forces"] as const;
export const teamTopics = [
  "/team/objects",
  "/team/map",
  "/team/program_push",
  "/team/push_progress",
  "/team/lease_change",
  "/referee/score",
  "/simulation/state",
  "/simulation/event",
] as const;

/** No topic but a parameter of the monitor: the names of the robots that a recording plays in the domain. */
export const REPLAYED = "/team.replayed";
/** A parameter, too: what is wrong with the monitor's history or its disk, in one sentence; empty where nothing is. */
export const HISTORY_PROBLEM = "/team.history_problem";
/** And a parameter: what is wrong with the monitor's map, in one sentence; empty where nothing is. */
export const MAP_PROBLEM = "/team.map_problem";
/** A parameter as well: the robots that somebody holds, with who does and who asks for them. */
export const LEASES = "/team.leases";
/** A parameter as well: which changes of state fill a gap, by robot, as ranges of their numbers. */
export const FILLED = "/team.filled";
/** The parameters that the page follows. */
export const parameters = [REPLAYED, HISTORY_PROBLEM, MAP_PROBLEM, LEASES, FILLED] as const;
export type FollowedParameter = (typeof parameters)[number];

export type RobotTopic = (typeof robotTopics | typeof watchedTopics)[number];
export type TeamTopic = (typeof teamTopics)[number];
/** A robot's picture: its camera's own, or a channel that its catalog names. */
export type Picture = string;
export const CAMERA: Picture = "camera";

const NOT_ROBOTS = new Set(["team", "referee", "simulation"]);

/** The robot and the rest of "/io/state", or undefined where no robot is named. */
export function robotTopicOf(topic: string): { robot: string; kind: string } | undefined {
  const [, robot, kind] = /^\/([^/]+)\/(.+)$/.exec(topic) ?? [];
  return robot && kind && !NOT_ROBOTS.has(robot) ? { robot, kind } : undefined;
}

const HAPPENINGS = new Set(["transition", "program", "program_reply", "team/program_push", "team/push_progress", "team/lease_change", "simulation/event"]);

/** Whether a topic tells of single events, which are worth a frame of their own, rather than how things stand. */
export function tellsWhatHappens(topic: string): boolean {
  return HAPPENINGS.has(robotTopicOf(topic)?.kind ?? topic.slice(1));
}

export function pictureTopic(robot: string, picture: Picture): string {
  return `/${robot}/${picture}/compressed`;
}

export function isPictureTopic(topic: string): boolean {
  return topic.endsWith("/compressed");
}

/** Whether the page listens to `topic` all the time; pictures are asked for one by one. */
export function isAlwaysWanted(topic: string): boolean {
  if ((teamTopics as readonly string[]).includes(topic)) return true;
  const named = robotTopicOf(topic);
  return named !== undefined && (robotTopics as readonly string[]).includes(named.kind);
}
