// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, expect, it, vi } from "vitest";
import { Operator } from "../../src/model/operator.svelte";
import type { Questions } from "../fixture/answers";

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
  expect(operator.failure).toBe("STOP did not reach the robots: The monitor does not answer. io was not told to hold: It is busy.");
});

it("tells of a failure until the next word", async () => {
  operator.stopAll();
  await questions.of("command").refuse(new Error("The monitor does not answer."));
  operator.stopAll();
  expect(operator.failure).toBeUndefined();
  await questions.of("command").answer({ id: "1" });
  expect(operator.failure).toBeUndefined();
});
