// What on the map can be chosen: every robot that has a place, and every object.

import type { Side } from "../layout/tree";
import type { Team } from "../model/model";

export interface Thing {
  readonly key: string;
  readonly x_m: number;
  readonly y_m: number;
}

export const keyOf = {
  robot: (name: string) => `robot ${name}`,
  object: (id: number) => `object ${id}`,
};

export function thingsOn(team: Team): Thing[] {
  const robots = [...team.robots.values()].flatMap(({ name, pose }) => (pose ? [{ key: keyOf.robot(name), x_m: pose.x_m, y_m: pose.y_m }] : []));
  const objects = (team.objects?.value ?? []).map(({ id, x_m, y_m }) => ({ key: keyOf.object(id), x_m, y_m }));
  return [...robots, ...objects];
}

/** Unit vectors on the map, y up. */
const TOWARDS: Record<Side, readonly [x: number, y: number]> = { left: [-1, 0], right: [1, 0], up: [0, 1], down: [0, -1] };

/** The nearest thing on that side; one that lies askew counts as farther. */
export function nextThing(things: readonly Thing[], from: Thing, side: Side): Thing | undefined {
  const [x, y] = TOWARDS[side];
  let [next, least] = [undefined as Thing | undefined, Number.POSITIVE_INFINITY];
  for (const thing of things) {
    const [dx, dy] = [thing.x_m - from.x_m, thing.y_m - from.y_m];
    const [ahead, aside] = [dx * x + dy * y, Math.abs(dx * y - dy * x)];
    const far = ahead + 2 * aside;
    if (thing.key === from.key || ahead <= 0 || far >= least) continue;
    [next, least] = [thing, far];
  }
  return next;
}
