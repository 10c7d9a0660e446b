// SPDX-License-Identifier: BSD-3-Clause
import { expect, test } from "vitest";
import type { Alarm, PostedAlarm } from "../../src/model/alarms";
import { identityOf } from "../../src/model/identity";
import type { Robot } from "../../src/model/model";
import { alarmNotices, heldNotice, linkNotice, replayNotice } from "../../src/wall/notices";
import { CELLS, conditionOf, shownRobots } from "../../src/wall/wall_robots";

const NOW_MS = 100_000;

function robot(name: string, state: object = {}, heard_ms = NOW_MS): Robot {
  const value = { held: false, out_of_service: false, problems: [], ...state };
  return { name, identity: identityOf(name, []), heard_ms, state: { value, received_ms: heard_ms } } as unknown as Robot;
}
const alarm = (words: string, over_ms?: number, more: Partial<Alarm> = {}): PostedAlarm =>
  ({ alarm: { key: words, kind: "problem", robot: "io", words, advice: "", ...more }, since_ms: NOW_MS - 12_000, seen: false, ...(over_ms && { over_ms }) }) as PostedAlarm;

test("a robot's condition is the worst that is known of it", () => {
  expect(conditionOf(robot("io"), NOW_MS)).toBe("well");
  expect(conditionOf(robot("io", { held: true }), NOW_MS)).toBe("held");
  expect(conditionOf(robot("io", { held: true, problems: ["no camera"] }), NOW_MS)).toBe("problem");
  expect(conditionOf(robot("io", { held: true }, NOW_MS - 5000), NOW_MS)).toBe("silent");
});

test("where there is no room for all, those in trouble stay, in their order", () => {
  const robots = Array.from({ length: CELLS + 5 }, (_, i) => robot(`robot${i}`, { held: i === CELLS + 2 }));
  const { shown, left } = shownRobots(robots, NOW_MS);
  expect([shown.length, left]).toEqual([CELLS - 1, 6]);
  expect(shown.at(-1)?.name).toBe(`robot${CELLS + 2}`);
  expect(shownRobots(robots.slice(0, CELLS), NOW_MS)).toMatchObject({ left: 0 });
});

test("the connection is told of as it is", () => {
  const link = { wasLive: true, lostFor_ms: undefined, behind_ms: 0, isBehind: false };
  expect(linkNotice(link)).toBeUndefined();
  expect(linkNotice({ ...link, behind_ms: 12_000, isBehind: true })?.words).toBe("This page is 12 s behind.");
  expect(linkNotice({ ...link, lostFor_ms: 11_000, behind_ms: 12_000, isBehind: true })?.words).toBe("Nothing heard for 11 s: this page is 12 s behind.");
  expect(linkNotice({ ...link, wasLive: false })?.words).toBe("Connecting to the monitor…");
  expect(linkNotice({ ...link, wasLive: false, lostFor_ms: 30_000 })?.words).toBe("The monitor does not answer, for 30 s.");
});

test("of a recording is told why it is not shown, or what is wrong with it", () => {
  expect(replayNotice(undefined, true)).toBeUndefined();
  expect(replayNotice("There is no recording gone.mcap.", false)).toEqual({ kind: "connection", words: "There is no recording gone.mcap." });
  expect(replayNotice("cut.mcap is damaged.", true)).toEqual({ kind: "recording", words: "cut.mcap is damaged." });
});

test("of many alarms one is told whole and the others are counted; what is over is not told", () => {
  const words = (posted: PostedAlarm[]) => alarmNotices(posted, NOW_MS).map((notice) => notice.words);
  expect(words([alarm("a."), alarm("b."), alarm("c.", NOW_MS)])).toEqual(["a, for 12 s.", "b, for 12 s."]);
  expect(words([alarm("a."), alarm("b."), alarm("c.")])).toEqual(["a, for 12 s.", "2 more alarms."]);
});

test("alarms of one kind of several robots are one, as in the team's panel, with as many names as there is room for", () => {
  const silent = (robot: string) => alarm(`${robot} is silent.`, undefined, { kind: "silent", robot });
  const words = (posted: PostedAlarm[]) => alarmNotices(posted, NOW_MS).map((notice) => notice.words);
  expect(words([silent("io"), alarm("a."), silent("europa")])).toEqual(["2 robots silent: io, europa.", "a, for 12 s."]);
  expect(words([..."abcdef"].map(silent))).toEqual(["6 robots silent: a, b, c, d and 2 more."]);
  expect(words([silent("io"), silent("europa"), alarm("a."), alarm("b.")])).toEqual(["2 robots silent: io, europa.", "2 more alarms."]);
});

test("that all are held is said of those in service, and by no word of a silent one", () => {
  const words = (...robots: Robot[]) => heldNotice(robots, NOW_MS)?.words;
  expect(words()).toBeUndefined();
  expect(words(robot("io", { held: true }), robot("ganymede"))).toBeUndefined();
  expect(words(robot("io", { held: true }), robot("ganymede", { held: true }), robot("callisto", { out_of_service: true }))).toBe("All robots are held.");
  expect(words(robot("io", { held: true }, NOW_MS - 5000))).toBeUndefined();
});

test("all is never said where one is silent or has told nothing yet", () => {
  const words = (...robots: Robot[]) => heldNotice([robot("io", { held: true }), ...robots], NOW_MS)?.words;
  const silent = (name: string, state = {}) => robot(name, state, NOW_MS - 5000);
  expect(words(robot("ganymede", { held: true }), silent("callisto"))).toBe("2 robots are held; callisto is silent.");
  expect(words(silent("callisto", { held: true }), silent("europa", { out_of_service: true }))).toBe("1 robot is held; callisto and europa are silent.");
  expect(words(..."abcdef".split("").map((name) => silent(name)))).toBe("1 robot is held; 6 robots are silent.");
  expect(words({ ...robot("callisto"), state: undefined } as unknown as Robot)).toBe("1 robot is held; callisto has told no state yet.");
});
