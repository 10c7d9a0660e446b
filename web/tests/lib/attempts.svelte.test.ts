// SPDX-License-Identifier: BSD-3-Clause
import { flushSync } from "svelte";
import { beforeEach, expect, it } from "vitest";
import { Attempts } from "../../src/lib/attempts.svelte";
import { Questions } from "../fixture/answers";

let attempts: Attempts;
let questions: Questions;
let attempt: () => Promise<unknown>;
beforeEach(() => {
  [attempts, questions] = [new Attempts(), new Questions()];
  const operation = questions.operation("ask");
  attempt = () => attempts.make(operation);
});

it("is busy until the last of several attempts has ended", async () => {
  void attempt();
  void attempt();
  await questions.of("ask", 1).answer("second");
  expect(attempts.busy).toBe(true);
  await questions.of("ask", 0).refuse(new Error("No."));
  expect(attempts.busy).toBe(false);
});

it("tells of each failure until the next attempt", async () => {
  void attempt();
  void attempt();
  await questions.of("ask", 1).refuse(new Error("No."));
  await questions.of("ask", 0).refuse(new Error("Never."));
  expect(attempts.failure).toBe("No. Never.");
  const third = attempt();
  expect(attempts.failure).toBeUndefined();
  await questions.of("ask").answer("yes");
  expect(await third).toBe("yes");
});

it("says once what fails twice in one way", async () => {
  void attempt();
  void attempt();
  await questions.of("ask", 1).refuse(new Error("The monitor does not answer."));
  await questions.of("ask", 0).refuse(new Error("The monitor does not answer."));
  expect(attempts.failure).toBe("The monitor does not answer.");
});

it("is begun once by an effect, however it goes on", async () => {
  const end = $effect.root(() => {
    $effect(() => void attempt());
  });
  flushSync();
  await questions.of("ask").refuse(new Error("No."));
  flushSync();
  expect(questions.count("ask")).toBe(1);
  end();
});
