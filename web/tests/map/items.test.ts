// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { itemAfter, type MapItem, itemsOn, nextItem } from "../../src/map/items";
import { knownOf } from "../../src/map/known";
import type { MapObject } from "../../src/feed/messages";
import { mapRobot, state, T0_MS, time, told } from "../model/told";

const item = (key: string, x_m: number, y_m: number): MapItem => ({ key, x_m, y_m });

describe("going from item to item", () => {
  const all = [item("middle", 0, 0), item("ahead", 0, 2), item("askew", 1.5, 1), item("right", 3, 0.2)];
  it("takes the nearest that lies that way, not one far aside", () => {
    expect(nextItem(all, all[0]!, "up")?.key).toBe("ahead");
    expect(nextItem(all, all[0]!, "right")?.key).toBe("right");
    expect(nextItem(all, all[0]!, "left")).toBeUndefined();
  });
  it("goes through all of them in their order, round and round, also where two lie in one place", () => {
    const twins = [item("one", 1, 1), item("twin", 1, 1), item("far", 5, 1)];
    expect(nextItem(twins, twins[2]!, "left")?.key).toBe("one");
    expect(itemAfter(twins, twins[0]!, 1)?.key).toBe("twin");
    expect(itemAfter(twins, twins[2]!, 1)?.key).toBe("one");
    expect(itemAfter(twins, twins[0]!, -1)?.key).toBe("far");
  });
});

const can: MapObject = {
  id: 7, object_class: "trash", x_m: 1, y_m: 2, variance_xx: 0.01, variance_xy: 0, variance_yy: 0.0025, certainty: 0.8,
  decay_per_s: 0.05, last_seen: time(T0_MS - 3000), seen_by: ["io", "callisto"], held_by: "",
};
const team = told([
  ["/io/state", state({ x_m: 0.1, heading_rad: Math.PI / 2 }), T0_MS],
  ["/team/objects", { stamp: time(T0_MS), objects: [can], robots: [mapRobot({ x_m: 1, y_m: 0 })] }, T0_MS],
]);

describe("what is known", () => {
  const factsOf = (key: string) => Object.fromEntries(knownOf(key, team, T0_MS + 2000)!.facts);

  it("of an object: how sure, for how long yet, where within what, seen when and by whom", () => {
    expect(factsOf("object 7")).toMatchObject({
      certainty: "0.70, forgotten in 14 s", at: "1.00, 2.00 m", within: "0.20 m × 0.10 m", "seen by": "io, callisto",
      "last seen": "5.0 s ago", distance: "io 2.0 m",
    });
  });

  it("of a robot: what it does, where it is on the map and where it believes to be", () => {
    expect(factsOf("robot io")).toMatchObject({ does: "start", at: "1.00, 0.00 m", "by its own reckoning": "0.10, 0.00 m, 90°" });
  });

  it("of a robot: how well its place is known, what it carries and what it sees", () => {
    const carried = { ...can, id: 8, held_by: "io" };
    const sighting = (object_class: string) => ({ object_class });
    const busy = told([
      ["/io/state", state({ held: true, state: "drop" }), T0_MS],
      ["/ganymede/state", state({ robot: "ganymede" }), T0_MS],
      ["/io/sightings", { items: [sighting("trash"), sighting("basket"), sighting("trash")] }, T0_MS],
      ["/team/objects", { stamp: time(T0_MS), objects: [can, carried], robots: [mapRobot({ variance_xx: 0.04, variance_yy: 0.01, heading_rad: -Math.PI / 2 })] }, T0_MS],
    ]);
    const facts = (now_ms: number, key = "robot io") => Object.fromEntries(knownOf(key, busy, now_ms)!.facts);
    expect(facts(T0_MS + 100)).toMatchObject({ does: "drop, held", heads: "−90°", within: "0.40 m × 0.20 m", carries: "trash 8", sees: "2 trash, 1 basket" });
    expect(facts(T0_MS + 100)).not.toHaveProperty("silent for");
    expect(facts(T0_MS + 1500).sees).toBe("nothing");
    expect(facts(T0_MS + 9000)["silent for"]).toBe("9.0 s");
    expect(facts(T0_MS + 100, "object 8")).toMatchObject({ "carried by": "io" });
    const unplaced = facts(T0_MS + 100, "robot ganymede");
    expect(unplaced).toMatchObject({ does: "start", carries: "nothing", sees: "nothing" });
    expect(unplaced).not.toHaveProperty("within");
  });

  it("of an object: the nearest robots first", () => {
    const three = told([
      ["/team/objects", { stamp: time(T0_MS), objects: [{ ...can, seen_by: [] }], robots: [mapRobot({ x_m: 1, y_m: 6 }), mapRobot({ name: "ganymede", x_m: 1, y_m: 3 }), mapRobot({ name: "callisto", x_m: 3, y_m: 2 })] }, T0_MS],
    ]);
    expect(Object.fromEntries(knownOf("object 7", three, T0_MS)!.facts)).toMatchObject({ distance: "ganymede 1.0 m, callisto 2.0 m, io 4.0 m", "seen by": "nobody lately" });
  });

  it("is nothing once it is forgotten", () => {
    expect(knownOf("object 8", team, T0_MS)).toBeUndefined();
  });

  it("can be chosen item by item", () => {
    expect(itemsOn(team).map(({ key }) => key)).toEqual(["robot io", "object 7"]);
  });
});
