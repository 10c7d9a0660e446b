// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { groupedAlarms, groupWords, wordsByRobot } from "../../src/model/alarm_groups";
import { acknowledged, type AlarmKind, type PostedAlarm } from "../../src/model/alarms";

const one = (kind: AlarmKind, robot: string, more: Partial<PostedAlarm> = {}): PostedAlarm =>
  ({ alarm: { key: `${kind} ${robot}`, kind, robot, words: `${robot} is ${kind}.`, advice: "" }, since_ms: 1000, seen: false, ...more });
const robotsIn = (board: readonly PostedAlarm[]) => groupedAlarms(board).map(({ key, posted }) => [key, posted.map(({ alarm }) => alarm.robot).join(" ")]);

it("puts the alarms of one kind of several robots together, in the board's order", () => {
  expect(robotsIn([one("silent", "io"), one("stuck", "europa"), one("silent", "callisto")])).toEqual([["silent", "io callisto"], ["stuck europa", "europa"]]);
});

it("says how many robots, what they are, and which", () => {
  expect(groupedAlarms([one("silent", "io"), one("silent", "callisto")]).map((group) => groupWords(group))).toEqual(["2 robots silent: io, callisto"]);
  expect(groupedAlarms([one("stuck", "io", { over_ms: 5000 }), one("stuck", "callisto", { over_ms: 6000 })]).map((group) => groupWords(group))).toEqual(["2 robots did not move: io, callisto"]);
});

it("does not call a sender of messages that are not taken a robot", () => {
  expect(groupedAlarms([one("refused", "io"), one("refused", "team")]).map((group) => groupWords(group))).toEqual(["2 senders send messages that are not taken: io, team"]);
});

it("keeps those that were seen, and those that are over, apart from those that are new", () => {
  const board = [one("silent", "a"), one("silent", "b"), one("silent", "c", { over_ms: 5000 }), one("silent", "d", { seen: true }), one("silent", "e", { seen: true })];
  expect(robotsIn(board)).toEqual([["silent", "a b"], ["silent c", "c"], ["silent seen", "d e"]]);
});

it("leaves several alarms of one robot alone", () => {
  const board = [one("problem", "io"), { ...one("problem", "io"), alarm: { ...one("problem", "io").alarm, key: "problem io 2" } }];
  expect(robotsIn(board)).toEqual([["problem io", "io"], ["problem io 2", "io"]]);
});

it("is acknowledged as a whole, and nothing else with it", () => {
  const board = [one("silent", "io"), one("silent", "callisto"), one("stuck", "europa")];
  const [group] = groupedAlarms(board);
  const after = acknowledged(board, group!.posted.map(({ alarm }) => alarm.key));
  expect(after.map(({ alarm, seen }) => [alarm.robot, seen])).toEqual([["io", true], ["callisto", true], ["europa", false]]);
});

it("tells the words of each robot that has an alarm", () => {
  const board = [one("stuck", "io"), one("problem", "io"), one("silent", "callisto")];
  expect([...wordsByRobot(board.map(({ alarm }) => alarm))]).toEqual([["io", ["io is stuck.", "io is problem."]], ["callisto", ["callisto is silent."]]]);
});
