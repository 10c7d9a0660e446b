// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import type { RefusedMessages } from "../../src/feed/api";
import { type PostedAlarm, sentenceOf, withAlarms } from "../../src/model/alarms";
import { Intake } from "../../src/model/intake";

const NOT_A_NUMBER = "RobotState.heading_rad is not a number";
const refused = (messages: number, topic = "rt/io/state", reason = NOT_A_NUMBER): RefusedMessages => ({ topic, reason, messages });
const said = (intake: Intake, now_ms: number) => intake.alarms(now_ms).map(({ words }) => words);

it("says which messages were not taken, why, and how many, and how to find who sends them", () => {
  const intake = new Intake();
  expect(intake.alarms(0)).toEqual([]);
  intake.told({ refused_messages: [refused(12), refused(1, "(others)", "more than 256 robots are not followed, such as europa")], topics_not_read: 0 }, 1000);
  const [io, others] = intake.alarms(2000);
  expect(io).toMatchObject({ kind: "refused", robot: "io", words: `12 messages on /io/state were not taken: ${NOT_A_NUMBER}.` });
  expect(io!.advice).toContain("galilean info /io/state");
  expect(others).toMatchObject({ robot: "(others)", words: "1 message was not taken: more than 256 robots are not followed, such as europa." });
});

it("tells of topics that are not read", () => {
  const intake = new Intake();
  intake.told({ refused_messages: [], topics_not_read: 3 }, 1000);
  expect(said(intake, 2000)).toEqual(["3 topics are not read, because there are too many."]);
});

it("tells of events that were lost, and not of those that filled a gap", () => {
  const intake = new Intake();
  const tell = (lost: number, now_ms: number) => intake.told({ channels: [{ topic: "rt/io/transition", lost }], refused_messages: [], topics_not_read: 0 }, now_ms);
  tell(0, 0);
  expect(intake.alarms(1000)).toEqual([]);
  tell(12, 5000);
  expect(intake.alarms(6000)).toMatchObject([{ kind: "lost", robot: "io", words: "12 messages on /io/transition were lost: more happened in a gap than the robot keeps." }]);
  tell(12, 20_000);
  expect(intake.alarms(40_000)).toEqual([]);
});

it("is over when no more come, and is an alarm again when they do", () => {
  const intake = new Intake();
  const tell = (messages: number, now_ms: number) => intake.told({ refused_messages: [refused(messages)], topics_not_read: 0 }, now_ms);
  tell(1, 0);
  for (let now_ms = 5000; now_ms < 30_000; now_ms += 5000) tell(1, now_ms);
  expect(intake.alarms(29_000).length).toBe(1);
  expect(intake.alarms(30_000)).toEqual([]);
  tell(2, 35_000);
  expect(intake.alarms(36_000).length).toBe(1);
});

it("does not go on because a monitor that was started anew has refused nothing yet", () => {
  const intake = new Intake();
  intake.told({ refused_messages: [refused(7)], topics_not_read: 2 }, 0);
  intake.told({ refused_messages: [], topics_not_read: 0 }, 5000);
  expect(intake.alarms(6000)).toEqual([]);
  intake.told({ refused_messages: [refused(7)], topics_not_read: 0 }, 60_000);
  expect(intake.alarms(61_000).length).toBe(1);
});

it("stays one alarm on the board while its count rises", () => {
  const intake = new Intake();
  let board: readonly PostedAlarm[] = [];
  for (const messages of [1, 2, 3]) {
    intake.told({ refused_messages: [refused(messages)], topics_not_read: 0 }, messages * 5000);
    board = withAlarms(board, intake.alarms(messages * 5000), messages * 5000);
  }
  expect(board.map(({ since_ms }) => since_ms)).toEqual([5000]);
  expect(sentenceOf(board[0]!, 15_000)).toBe(`3 messages on /io/state were not taken: ${NOT_A_NUMBER}`);
  board = withAlarms(board, intake.alarms(60_000), 60_000);
  expect(sentenceOf(board[0]!, 60_000)).toBe(`3 messages on /io/state were not taken: ${NOT_A_NUMBER}; over after 55 s`);
});
