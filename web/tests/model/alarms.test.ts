// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { ProgramReply_Constants } from "../../src/feed/messages";
import { HISTORY_PROBLEM, MAP_PROBLEM, REPLAYED } from "../../src/feed/topics";
import { acknowledged, type Alarm, alarms, sentenceOf, withAlarms } from "../../src/model/alarms";
import { breaks, mapRobot, state, T0_MS, time, told, transition } from "./told";

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
  it("tell of a robot whose clock is ahead, unless a recording plays it", () => {
    const ahead: Told[] = [["/io/state", state({ stamp: time(T0_MS + 3_600_000) }), T0_MS]];
    expect(alarms(told(ahead), T0_MS).map(({ words }) => words)).toEqual(["io: its clock is 3600 s ahead"]);
    expect(kinds([...ahead, [REPLAYED, ["io"], 0]], T0_MS)).toEqual([]);
    expect(kinds([["/io/state", state({ stamp: time(T0_MS + 2000) }), T0_MS]], T0_MS)).toEqual([]);
  });
  it("tell of ticks that began late, for a while", () => {
    const late: Told[] = [["/io/state", state({ overruns: 1 }), T0_MS], ["/io/state", state({ overruns: 2 }), T0_MS + 100]];
    expect(kinds(late, T0_MS + 1000)).toEqual(["io overrun"]);
    const stillHeard: Told[] = [...late, ["/io/state", state({ overruns: 2, x_m: 1 }), T0_MS + 30_000]];
    expect(kinds(stillHeard, T0_MS + 30_000)).toEqual([]);
  });
  it("tell of late ticks whatever else happened since", () => {
    const messages: Told[] = [
      ["/io/state", state(), T0_MS],
      ["/io/state", state({ overruns: 3 }), T0_MS + 100],
      ["/io/state", state({ overruns: 3, held: true }), T0_MS + 200],
    ];
    expect(alarms(told(messages), T0_MS + 300).map(({ words }) => words)).toEqual(["io's ticks begin late (3 so far)."]);
    const onlyHeld: Told[] = [["/io/state", state(), T0_MS], ["/io/state", state({ held: true }), T0_MS + 100]];
    expect(kinds(onlyHeld, T0_MS + 300)).toEqual([]);
  });
  it("tell of a robot that runs another program than most", () => {
    const one = (robot: string, program_hash: string): Told => [`/${robot}/state`, state({ robot, program_hash }), T0_MS];
    expect(kinds([one("io", "a"), one("ganymede", "a"), one("callisto", "b")], T0_MS)).toEqual(["callisto drift"]);
  });
  it("tell nothing of a canary's program while its push runs", () => {
    const one = (robot: string, program_hash: string): Told => [`/${robot}/state`, state({ robot, program_hash }), T0_MS];
    const progress = { stamp: { sec: 0, nsec: 0 }, id: "p1", author: "operator", program: "b.bhdl", hash: "b", targets: [], state: "running", steps: [] };
    expect(kinds([one("io", "a"), one("ganymede", "a"), one("callisto", "b"), ["/team/push_progress", progress, T0_MS]], T0_MS)).toEqual([]);
  });
  it("measure a robot's program by those that are in service", () => {
    const one = (robot: string, program_hash: string, out_of_service = false): Told => [`/${robot}/state`, state({ robot, program_hash, out_of_service }), T0_MS];
    expect(kinds([one("io", "a"), one("ganymede", "b", true), one("callisto", "b", true)], T0_MS)).toEqual([]);
  });
  it("do not tell of the silence and the program of a robot that a recording plays", () => {
    const one = (robot: string, program_hash: string, at_ms = T0_MS): Told => [`/${robot}/state`, state({ robot, program_hash }), at_ms];
    const played: Told = [REPLAYED, ["ganymede", "callisto", "europa"], 0];
    expect(kinds([one("io", "a"), one("ganymede", "b"), one("callisto", "b"), one("europa", "b", T0_MS - 9000), played], T0_MS)).toEqual([]);
  });
  it("tell what is wrong with the monitor's map, as long as it is", () => {
    const still: Told = [MAP_PROBLEM, "The map has stood still for 4 s. Stop, hold and all other commands go on without it.", 0];
    expect(alarms(told([still]), T0_MS).map(({ key, words }) => [key, words])).toEqual([["map", still[1]]]);
    expect(alarms(told([still, [MAP_PROBLEM, "", 0]]), T0_MS)).toEqual([]);
  });
  it("tell what is wrong with the monitor's history, as long as it is", () => {
    const full: Told = [HISTORY_PROBLEM, "The history of pushes is in danger: the disk is full.", 0];
    expect(alarms(told([full]), T0_MS).map(({ key, words }) => [key, words])).toEqual([["history", full[1]]]);
    expect(alarms(told([full, [HISTORY_PROBLEM, "", 0]]), T0_MS)).toEqual([]);
  });
  it("tell of a robot that does not move though nobody holds it", () => {
    const standing = (changes: object): Told[] => [0, 10, 21].map((s) => ["/io/state", state({ ...moving, ...changes }), T0_MS + s * 1000]);
    expect(kinds(standing({}), T0_MS + 21_000)).toEqual(["io stuck"]);
    expect(kinds(standing({ held: true }), T0_MS + 21_000)).toEqual([]);
    const turning: Told[] = [0, 10, 21].map((s) => ["/io/state", state({ ...moving, heading_rad: s / 10 }), T0_MS + s * 1000]);
    expect(kinds(turning, T0_MS + 21_000)).toEqual([]);
  });
  it("say for how long, and in which state, a robot has stood", () => {
    const standing: Told[] = [0, 10, 25].map((s) => ["/io/state", state(moving), T0_MS + s * 1000]);
    expect(alarms(told(standing), T0_MS + 25_000).map(({ words }) => words)).toEqual(["io has not moved for 25 s in wander."]);
    const notYet: Told[] = [0, 10, 19].map((s) => ["/io/state", state(moving), T0_MS + s * 1000]);
    expect(kinds(notYet, T0_MS + 19_000)).toEqual([]);
  });
  it("tell of a robot that goes round the same states without getting anywhere", () => {
    const states = ["grab", "backup", "remember", "wander"];
    const changes = Array.from({ length: 57 }, (_, i): Told => ["/io/transition", transition(i + 1, states[i % 4]!, T0_MS + i * 178), T0_MS + i * 178]);
    const end_ms = T0_MS + 10_000;
    const last = (held: boolean): Told => ["/io/state", state({ at_ms: end_ms, state: "grab", transitions: 57n, state_since: time(T0_MS + 56 * 178), held }), end_ms];
    const looping: Told[] = [["/io/state", state({ at_ms: T0_MS - 5000 }), T0_MS - 5000], ...changes, last(false)];
    expect(alarms(told(looping), end_ms).map(({ kind, words }) => [kind, words])).toEqual([["loop", "io goes round backup → remember → wander → grab, 14 times in 10 s."]]);
    expect(kinds([...looping, last(true)], end_ms)).toEqual([]);
  });
  it("do not call a robot stuck that waits to be started", () => {
    const program = { start_state: "wander", states: [], transitions: [], files: [], name: "", hash: "", robot: "io", stamp: { sec: 0, nsec: 0 } };
    const waiting: Told[] = [["/io/program", program, T0_MS], ...[0, 10, 21].map((s): Told => ["/io/state", state(moving), T0_MS + s * 1000])];
    expect(kinds(waiting, T0_MS + 21_000)).toEqual([]);
  });
  it("do not call a robot stuck that waits at a lock for an operator", () => {
    const waits = breaks({ waits_at_from: "wander", waits_at_to: "grab" });
    const waiting: Told[] = [...[0, 10, 21].map((s): Told => ["/io/state", state(moving), T0_MS + s * 1000]), ["/io/breaks", waits, T0_MS + 21_000]];
    expect(kinds(waiting, T0_MS + 21_000)).toEqual([]);
  });
  it("tell of a robot whose place is not known well", () => {
    const at = (variance: number): Told[] => [
      ["/io/state", state(moving), T0_MS],
      ["/team/objects", { stamp: { sec: 0, nsec: 0 }, objects: [], robots: [mapRobot({ variance_xx: variance, variance_yy: 0.01 })] }, T0_MS],
    ];
    expect(kinds(at(0.25), T0_MS)).toEqual(["io uncertain"]);
    expect(kinds(at(0.04), T0_MS)).toEqual([]);
  });
  it("tell only of silence where the map no longer hears a robot, not of its place", () => {
    const placed = mapRobot({ variance_xx: 0.25, variance_yy: 0.25, silent: true });
    const messages: Told[] = [
      ["/io/state", state(moving), T0_MS],
      ["/team/objects", { stamp: { sec: 0, nsec: 0 }, objects: [], robots: [placed] }, T0_MS],
    ];
    expect(kinds(messages, T0_MS)).toEqual(["io silent"]);
  });
  describe("of pushes", () => {
    const stamp = { sec: 0, nsec: 0 };
    const push = (id: string, hash = "bbbb"): Told => ["/team/program_push", { stamp, id, author: "operator", targets: [], replaces_hash: "", hash, files: [{ path: "sit_and_spin.bhdl", text: "" }] }, T0_MS];
    const reply = (robot: string, status: number, message = "", id = "p1"): Told =>
      [`/${robot}/program_reply`, { stamp, id, robot, hash: "bbbb", running_hash: "", status, message, tick: 0n, swap_tick_us: 8, kept_variables: [], diagnostics: [] }, T0_MS];
    const { CONFIRMED, REJECTED, ROLLED_BACK } = ProgramReply_Constants;

    it("tell of each robot that refused one, or went back from it", () => {
      const found = alarms(told([push("p1"), reply("io", CONFIRMED), reply("ganymede", REJECTED, "no such schema"), reply("callisto", ROLLED_BACK, "overruns")]), T0_MS);
      expect(found.map(({ kind, words, advice }) => [kind, words, advice])).toEqual([
        ["push", "ganymede refused sit_and_spin.bhdl.", "no such schema"],
        ["push", "callisto went back from sit_and_spin.bhdl.", "overruns"],
      ]);
      expect(new Set(found.map(({ key }) => key)).size).toBe(2);
    });
    it("are over once the robot answers a newer one, or runs it all the same", () => {
      const refused = [push("p1"), reply("io", REJECTED), reply("ganymede", REJECTED)];
      expect(kinds([...refused, push("p2"), reply("io", CONFIRMED, "", "p2")], T0_MS)).toEqual(["ganymede push"]);
      expect(kinds([...refused, ["/io/state", state({ program_hash: "bbbb" }), T0_MS]], T0_MS)).toEqual(["ganymede push"]);
    });
    it("are over two minutes after the answer", () => {
      const refused = [push("p1"), reply("io", REJECTED)];
      expect(kinds(refused, T0_MS + 119_000)).toEqual(["io push"]);
      expect(kinds(refused, T0_MS + 121_000)).toEqual([]);
    });
    it("say how long ago it was", () => {
      const [alarm] = alarms(told([push("p1"), reply("io", REJECTED)]), T0_MS);
      expect(sentenceOf({ alarm: alarm!, since_ms: 1000, over_ms: 121_000, seen: false }, 181_000)).toBe("io refused sit_and_spin.bhdl, 3 min ago");
    });
  });
  it("leave a robot that is out of service alone, but for its silence", () => {
    const away = state({ out_of_service: true, problems: ["motor: off"] });
    expect(kinds([["/io/state", away, T0_MS]], T0_MS)).toEqual([]);
    expect(kinds([["/io/state", away, T0_MS]], T0_MS + 9000)).toEqual(["io silent"]);
  });
});

describe("the sentence of a posted alarm", () => {
  const silent = alarms(told([["/io/state", state(), T0_MS]]), T0_MS + 9000)[0]!;

  it("says how long it lasts, and in the past tense how long it lasted: a silence since the robot was last heard", () => {
    const posted = { alarm: silent, since_ms: T0_MS + 9000, seen: false };
    expect(sentenceOf(posted, T0_MS + 12_000)).toBe("io is silent, for 12 s");
    expect(sentenceOf({ ...posted, over_ms: T0_MS + 12_000 }, T0_MS + 99_000)).toBe("io was silent for 12 s");
  });
  it("keeps when a silence began, so that the board stays the same", () => {
    const team = told([["/io/state", state(), T0_MS]]);
    const board = withAlarms([], alarms(team, T0_MS + 9000), T0_MS + 9000);
    const later = alarms(team, T0_MS + 9100).map((alarm) => ({ ...alarm, began_ms: alarm.began_ms! + 40 }));
    expect(withAlarms(board, later, T0_MS + 9100)).toBe(board);
  });
  it("adds no duration to words that say it", () => {
    const alarm: Alarm = { key: "loop io", kind: "loop", robot: "io", words: "io goes round a → b, 14 times in 10 s.", past: "io went round a → b", timed: true, advice: "" };
    expect(sentenceOf({ alarm, since_ms: 1000, seen: false }, 3000)).toBe("io goes round a → b, 14 times in 10 s");
    expect(sentenceOf({ alarm, since_ms: 1000, over_ms: 13_000, seen: false }, 99_000)).toBe("io went round a → b for 12 s");
  });
  it("calls another alarm over", () => {
    const alarm: Alarm = { key: "problem io", kind: "problem", robot: "io", words: "io: no picture", advice: "" };
    expect(sentenceOf({ alarm, since_ms: 1000, over_ms: 13_000, seen: false }, 99_000)).toBe("io: no picture; over after 12 s");
  });
});

describe("the board of alarms", () => {
  const alarm: Alarm = { key: "silent io", kind: "silent", robot: "io", words: "io is silent.", advice: "" };

  it("keeps an alarm that is over until somebody has seen it", () => {
    const over = withAlarms(withAlarms([], [alarm], 1000), [], 4000);
    expect(over).toEqual([{ alarm, since_ms: 1000, over_ms: 4000, seen: false }]);
    expect(acknowledged(over, [alarm.key])).toEqual([]);
  });
  it("keeps one that was seen as long as it lasts, quietly", () => {
    const seen = acknowledged(withAlarms([], [alarm], 1000));
    expect(withAlarms(seen, [alarm], 2000)).toEqual([{ alarm, since_ms: 1000, seen: true }]);
    expect(withAlarms(seen, [], 3000)).toEqual([]);
  });
  it("forgets one that was over at once", () => {
    expect(withAlarms(withAlarms([], [alarm], 1000), [], 1500)).toEqual([]);
  });
  it("stays the very same board as long as nothing changes", () => {
    const board = withAlarms([], [alarm], 1000);
    expect(withAlarms(board, [{ ...alarm }], 2000)).toBe(board);
    expect(withAlarms(board, [{ ...alarm, words: "io is silent again." }], 2000)).not.toBe(board);
    const over = withAlarms(board, [], 4000);
    expect(over).not.toBe(board);
    expect(withAlarms(over, [], 5000)).toBe(over);
  });
  it("takes one that comes again for a new one", () => {
    const over = withAlarms(withAlarms([], [alarm], 1000), [], 4000);
    expect(withAlarms(over, [alarm], 5000)).toEqual([{ alarm, since_ms: 5000, seen: false }]);
  });
});
