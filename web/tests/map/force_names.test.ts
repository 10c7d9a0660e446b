// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { placeNames } from "../../src/map/force_names";

const arrow = (schema: string, x: number, y: number, strength = 1) => ({ schema, x, y, strength });

describe("names of forces", () => {
  it("stand beyond the arrow's tip, on its side of the robot", () => {
    const names = placeNames([arrow("right_up", 30, -20), arrow("left_down", -30, 20)]);
    expect(names.get("right_up")).toEqual({ x: 34, y: -24, anchor: "start" });
    expect(names.get("left_down")).toEqual({ x: -34, y: 31, anchor: "end" });
  });

  it("leave each other room: of two over one another the stronger stays", () => {
    const names = placeNames([arrow("aso0", 40, -20, 0.3), arrow("go_to_trash", 42, -22, 0.9)]);
    expect([...names.keys()]).toEqual(["go_to_trash"]);
  });

  it("a line apart, or on either side, both stay", () => {
    expect(placeNames([arrow("aso0", 40, -20), arrow("go_to_trash", 42, -33)]).size).toBe(2);
    expect(placeNames([arrow("aso0", -40, -20), arrow("go_to_trash", 42, -22)]).size).toBe(2);
  });

  it("a long name reaches as far as its letters", () => {
    const names = placeNames([arrow("avoid_static_obstacle", 10, -20, 2), arrow("noise", 120, -20)]);
    expect([...names.keys()]).toEqual(["avoid_static_obstacle"]);
    expect(placeNames([arrow("aso", 10, -20, 2), arrow("noise", 120, -20)]).size).toBe(2);
  });

  it("turn inwards where the map ends, and are left out where they would be cut on both sides", () => {
    const room = { left: -200, right: 60, top: -100, bottom: 100 };
    expect(placeNames([arrow("noise", 50, -20)], room).get("noise")).toEqual({ x: 50, y: -24, anchor: "end" });
    expect(placeNames([arrow("noise", 20, -20)], room).get("noise")?.anchor).toBe("start");
    expect(placeNames([arrow("noise", 20, -20)], { ...room, left: -10, right: 40 }).size).toBe(0);
    expect(placeNames([arrow("noise", 20, -98)], room).size).toBe(0);
  });
});
