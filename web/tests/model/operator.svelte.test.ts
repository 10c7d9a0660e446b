// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Program } from "../../src/feed/messages";
import { Operator } from "../../src/model/operator.svelte";
import type { Questions } from "../fixture/answers";
import { live, runs } from "../fixture/fake_live.svelte";

const monitor = vi.hoisted(() => ({ questions: undefined as unknown as Questions }));
vi.mock("../../src/feed/api", async () => {
  monitor.questions = new (await import("../fixture/answers")).Questions();
  return { command: monitor.questions.operation("command") };
});
vi.mock("../../src/model/live.svelte", () => import("../fixture/fake_live.svelte"));

const { questions } = monitor;
let operator: Operator;
beforeEach(() => {
  questions.asked = [];
  operator = new Operator();
});

it("tells that STOP did not reach the robots, though another word fails after it", async () => {
  operator.stopAll();
  operator.hold("io");
  await questions.of("command", 0).refuse(new Error("The monitor does not answer."));
  await questions.of("command", 1).refuse(new Error("It is busy."));
  expect([operator.stopFailure, operator.failure]).toEqual(["STOP has not reached the robots: The monitor does not answer.", "io was not told to hold: It is busy."]);
});

describe("a STOP that the monitor does not take", () => {
  const deaf = new Error("The monitor does not answer.");
  let ordered_ms: number;
  beforeEach(async () => {
    live.reset();
    operator.stopAll();
    ordered_ms = Date.now();
    await questions.of("command").refuse(deaf);
  });

  it("is said to all again until it takes it, also where no robot is known, and the report stays as long", async () => {
    operator.refreshStop(ordered_ms + 1500);
    await questions.of("command", 1).refuse(deaf);
    operator.refreshStop(ordered_ms + 9000);
    expect(questions.asked.map(({ told }) => told)).toEqual([["hold", []], ["hold", []], ["hold", []]]);
    expect(operator.stopping).toBeDefined();
    await questions.of("command", 2).answer({ id: "1" });
    expect(operator.stopFailure).toBeUndefined();
  });
  it("is taken back at a word, and reaches nobody then", async () => {
    operator.dismissStop();
    operator.refreshStop(ordered_ms + 9000);
    expect([questions.asked.length, operator.stopping, operator.stopFailure]).toEqual([1, undefined, undefined]);
  });
});

it("sends STOP in the very task of the key, before anything is drawn", () => {
  operator.stopAll();
  expect(questions.asked.map(({ told }) => told)).toEqual([["hold", []]]);
});

it("counts a robot of a recording among the held ones as little as one out of service", () => {
  const held = (name: string, out_of_service = false) => ({ name, program: { value: {} as Program }, state: { value: { program_hash: "aaaa", held: true, out_of_service } } });
  live.robots = [held("io"), held("ganymede", true), held("callisto")];
  live.replayed = new Set(["callisto"]);
  expect(operator.held).toEqual(["io"]);
  live.reset();
});

it("tells of a failure until the next word", async () => {
  operator.hold("io");
  await questions.of("command").refuse(new Error("The monitor does not answer."));
  operator.hold("io");
  expect(operator.failure).toBeUndefined();
  await questions.of("command").answer({ id: "1" });
  expect(operator.failure).toBeUndefined();
});

it("tells nobody anything where a recording is shown, and says why", () => {
  live.playback = {};
  operator.stopAll();
  operator.resume([]);
  expect([questions.asked, operator.stopping]).toEqual([[], undefined]);
  expect(live.trouble).toMatch(/^This is a recording: a recording cannot be stopped or steered\./);
  live.reset();
});

describe("after STOP ALL", () => {
  const robot = (name: string, held: boolean, received_ms: number) => ({ ...runs(name, { name: "a.bhdl", hash: "aaaa", files: [] }), heard_ms: received_ms, state: { received_ms, value: { program_hash: "aaaa", held, out_of_service: false } } });
  let ordered_ms: number;
  beforeEach(() => {
    live.reset();
    operator.stopAll();
    ordered_ms = Date.now();
    void questions.of("command").answer({ id: "1" });
    live.robots = [robot("io", true, ordered_ms + 100), robot("callisto", false, ordered_ms - 100)];
  });
  const told = () => questions.asked.map(({ told }) => told[1]);

  it("those are told again every second that have not confirmed", () => {
    operator.refreshStop(ordered_ms + 500);
    operator.refreshStop(ordered_ms + 1500);
    operator.refreshStop(ordered_ms + 1600);
    operator.refreshStop(ordered_ms + 2600);
    expect(told()).toEqual([[], ["callisto"], ["callisto"]]);
  });
  it("the report goes some seconds after all have confirmed", () => {
    live.robots = [robot("io", true, ordered_ms + 100)];
    operator.refreshStop(ordered_ms + 200);
    operator.refreshStop(ordered_ms + 5100);
    expect(operator.stopping?.stopped).toEqual(["io"]);
    operator.refreshStop(ordered_ms + 5300);
    expect(operator.stopping).toBeUndefined();
  });
  it("nobody is told again once robots are resumed, or the report is dismissed", () => {
    operator.resume(["io"]);
    operator.refreshStop(ordered_ms + 5000);
    expect(operator.stopping).toBeUndefined();
    operator.stopAll();
    operator.dismissStop();
    operator.refreshStop(ordered_ms + 9000);
    expect(told()).toEqual([[], ["io"], []]);
  });
});
