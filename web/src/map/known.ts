// SPDX-License-Identifier: BSD-3-Clause
// All that is known of an item on the map, as an operator reads it.

import type { MapObject } from "../feed/messages";
import { seconds } from "../feed/parts";
import { degrees, lasting, metres, plural, signed } from "../lib/format";
import { breakReason, faultReason } from "../model/breaks";
import { certaintyAt, forgottenIn_s } from "../model/certainty";
import { ellipseOf } from "../model/ellipse";
import type { Robot, Team } from "../model/model";
import { age_s, isSilent } from "../model/silence";
import { keyOf } from "./items";

export interface Known {
  readonly title: string;
  readonly facts: readonly (readonly [name: string, words: string])[];
}

interface Place {
  readonly x_m: number;
  readonly y_m: number;
}

export const placeText = ({ x_m, y_m }: Place): string => `${signed(x_m, 2)}, ${metres(y_m)}`;

/** Undefined: nothing with that key is on the map any more. */
export function knownOf(key: string, team: Team, now_ms: number): Known | undefined {
  const objects = team.objects;
  const object = objects?.value.find(({ id }) => keyOf.object(id) === key);
  if (object) return knownOfObject(object, team, now_ms);
  const robot = [...team.robots.values()].find(({ name }) => keyOf.robot(name) === key);
  return robot && knownOfRobot(robot, team, now_ms);
}

function knownOfObject(object: MapObject, team: Team, now_ms: number): Known {
  const { received_ms, stamp } = team.objects!;
  const certainty = certaintyAt(object.certainty, object.decay_per_s, now_ms - received_ms);
  const { major_m, minor_m } = ellipseOf(object);
  const unseen_s = seconds(stamp) - seconds(object.last_seen) + (now_ms - received_ms) / 1000;
  return {
    title: `${object.object_class} ${object.id}`,
    facts: [
      ["certainty", certaintyText(certainty, object.decay_per_s)],
      ["at", placeText(object)],
      ["within", `${metres(major_m)} × ${metres(minor_m)}`],
      object.held_by ? ["carried by", object.held_by] : ["seen by", object.seen_by.join(", ") || "nobody lately"],
      ["last seen", `${lasting(unseen_s)} ago`],
      ["distance", distances(object, team)],
    ],
  };
}

function knownOfRobot(robot: Robot, team: Team, now_ms: number): Known {
  const { state, pose, placed, sightings } = robot;
  const carried = team.objects?.value.filter(({ held_by }) => held_by === robot.name) ?? [];
  const seen = sightings && now_ms - sightings.received_ms < 1000 ? sightings.value.items : [];
  const facts: [string, string][] = [["does", state ? `${state.value.state}${state.value.held ? ", held" : ""}` : "no state yet"]];
  const silent = isSilent(robot, now_ms);
  const reason = silent ? undefined : breakReason(robot, now_ms);
  if (reason) facts.push([faultReason(robot) ? "fault" : "break point", reason]);
  if (silent) facts.push(["silent for", lasting(age_s(robot, now_ms))]);
  if (pose) facts.push(["at", placeText(pose)], ["heads", degrees(pose.heading_rad)]);
  if (placed) facts.push(["within", `${metres(ellipseOf(placed).major_m)} × ${metres(ellipseOf(placed).minor_m)}`]);
  if (state) facts.push(["by its own reckoning", `${placeText(state.value)}, ${degrees(state.value.heading_rad)}`]);
  facts.push(["carries", carried.map(({ object_class, id }) => `${object_class} ${id}`).join(", ") || "nothing"]);
  facts.push(["sees", countedByClass(seen.map(({ object_class }) => object_class)) || "nothing"]);
  return { title: robot.name, facts };
}

export function certaintyText(certainty: number, decay_per_s: number): string {
  const left_s = forgottenIn_s(certainty, decay_per_s);
  return `${certainty.toFixed(2)}${left_s === undefined ? "" : `, forgotten in ${lasting(left_s)}`}`;
}

/** "2 trash, 1 basket" */
function countedByClass(classes: readonly string[]): string {
  const counts = new Map<string, number>();
  for (const each of classes) counts.set(each, (counts.get(each) ?? 0) + 1);
  return [...counts].map(([name, count]) => plural(count, name, name)).join(", ");
}

function distances({ x_m, y_m }: Place, team: Team): string {
  const near = [...team.robots.values()]
    .flatMap(({ name, pose }) => (pose ? [{ name, far_m: Math.hypot(pose.x_m - x_m, pose.y_m - y_m) }] : []))
    .sort((a, b) => a.far_m - b.far_m)
    .slice(0, 3);
  return near.map(({ name, far_m }) => `${name} ${far_m.toFixed(1)} m`).join(", ") || "no robot";
}
