import { describe, expect, it } from "vitest";
import { acknowledged, type Alarm, alarms, withAlarms } from "../../src/team/alarms";
import { mapRobot, state, T0_MS, told } from "./told";

type Told = [string, unknown, number];
const kinds = (messages: Told[], now_ms: number) => alarms(told(messages), now_ms).map(({ kind, robot }) => `${robot} ${kind}`);
const moving = { state: "wander", program_hash: "aaaa" };

describe("alarms", () => {
  it("tell of silence, and of what a robot complains of", () => {
    const messages: Told[] = [
      ["/io/state", state({ problems: ["frame_grabber: no picture for 2 s"] }), T0_MS],
      ["/ganymede/state", state({ robot: "ganymede" }), T0_MS - 9000],
    ];
    const found = alarms(told(messages), T0_MS);
    expect(found.map(({ words }) => words)).toEqual(["io: frame_grabber: no picture for 2 s", "ganymede is silent."]);
  });
  it("tell of ticks that began late, for a while", () => {
    const late: Told[] = [["/io/state", state({ overruns: 1 }), T0_MS], ["/io/state", state({ overruns: 2 }), T0_MS + 100]];
    expect(kinds(late, T0_MS + 1000)).toEqual(["io overrun"]);
    const stillHeard: Told[] = [...late, ["/io/state", state({ overruns: 2, x_m: 1 }), T0_MS + 30_000]];
    expect(kinds(stillHeard, T0_MS + 30_000)).toEqual([]);
  });
  it("tell of a robot that runs another program than most", () => {
    const one = (robot: string, program_hash: string): Told => [`/${robot}/state`, state({ robot, program_hash }), T0_MS];
    expect(kinds([one("io", "a"), one("ganymede", "a"), one("callisto", "b")], T0_MS)).toEqual(["callisto drift"]);
  });
  it("tell of a robot that does not move though nobody holds it", () => {
    const standing = (changes: object): Told[] => [0, 10, 21].map((s) => ["/io/state", state({ ...moving, ...changes }), T0_MS + s * 1000]);
    expect(kinds(standing({}), T0_MS + 21_000)).toEqual(["io stuck"]);
    expect(kinds(standing({ held: true }), T0_MS + 21_000)).toEqual([]);
    const turning: Told[] = [0, 10, 21].map((s) => ["/io/state", state({ ...moving, heading_rad: s / 10 }), T0_MS + s * 1000]);
    expect(kinds(turning, T0_MS + 21_000)).toEqual([]);
  });
  it("tell of a robot whose place is not known well", () => {
    const at = (variance: number): Told[] => [
      ["/io/state", state(moving), T0_MS],
      ["/team/objects", { stamp: { sec: 0, nsec: 0 }, objects: [], robots: [mapRobot({ variance_xx: variance, variance_yy: 0.01 })] }, T0_MS],
    ];
    expect(kinds(at(0.25), T0_MS)).toEqual(["io uncertain"]);
    expect(kinds(at(0.04), T0_MS)).toEqual([]);
  });
  it("leave a robot that is out of service alone, but for its silence", () => {
    const away = state({ out_of_service: true, problems: ["motor: off"] });
    expect(kinds([["/io/state", away, T0_MS]], T0_MS)).toEqual([]);
    expect(kinds([["/io/state", away, T0_MS]], T0_MS + 9000)).toEqual(["io silent"]);
  });
});

describe("the board of alarms", () => {
  const alarm: Alarm = { key: "silent io", kind: "silent", robot: "io", words: "io is silent.", advice: "" };

  it("keeps an alarm that is over until somebody has seen it", () => {
    const over = withAlarms(withAlarms([], [alarm], 1000), [], 2000);
    expect(over).toEqual([{ alarm, since_ms: 1000, over_ms: 2000, seen: false }]);
    expect(acknowledged(over, alarm.key)).toEqual([]);
  });
  it("keeps one that was seen as long as it lasts, quietly", () => {
    const seen = acknowledged(withAlarms([], [alarm], 1000));
    expect(withAlarms(seen, [alarm], 2000)).toEqual([{ alarm, since_ms: 1000, seen: true }]);
    expect(withAlarms(seen, [], 3000)).toEqual([]);
  });
  it("takes one that comes again for a new one", () => {
    const over = withAlarms(withAlarms([], [alarm], 1000), [], 2000);
    expect(withAlarms(over, [alarm], 3000)).toEqual([{ alarm, since_ms: 3000, seen: false }]);
  });
});
