// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, expect, it } from "vitest";
import { Latest } from "../../src/lib/latest";
import { Questions } from "../fixture/answers";

let latest: Latest;
let questions: Questions;
let used: unknown[];
let ask: () => Promise<boolean>;
beforeEach(() => {
  [latest, questions, used] = [new Latest(), new Questions(), []];
  const operation = questions.operation("ask");
  ask = () => latest.take(operation(), (answer) => used.push(answer));
});

it("uses the newest answer alone, whichever comes last", async () => {
  const [first, second] = [ask(), ask()];
  await questions.of("ask", 1).answer("second");
  await questions.of("ask", 0).answer("first");
  expect(used).toEqual(["second"]);
  expect([await first, await second]).toEqual([false, true]);
});

it("waits for no answer that is out of date", async () => {
  const first = ask();
  void ask();
  expect(await first).toBe(false);
});

it("tells of the newest failure alone", async () => {
  const [first, second] = [ask(), ask()];
  await questions.of("ask", 0).refuse(new Error("first"));
  expect(await first).toBe(false);
  void questions.of("ask", 1).refuse(new Error("second"));
  await expect(second).rejects.toThrow("second");
});

it("drops what is asked where told so, with or without a word", async () => {
  const quietly = ask();
  latest.supersede();
  expect(await quietly).toBe(false);
  const aloud = ask();
  latest.supersede(new Error("somebody typed"));
  await expect(aloud).rejects.toThrow("somebody typed");
  await questions.of("ask").answer("late");
  expect(used).toEqual([]);
});

it("leaves an answer that was used as it is", async () => {
  const first = ask();
  await questions.of("ask").answer("first");
  latest.supersede(new Error("too late"));
  expect(await first).toBe(true);
});

it("has used an answer whose use asks for more", async () => {
  const operation = questions.operation("ask");
  const first = latest.take(operation(), () => void ask());
  await questions.of("ask").answer("first");
  expect(await first).toBe(true);
  await questions.of("ask").answer("second");
  expect(used).toEqual(["second"]);
});

it("tells where an answer cannot be used", async () => {
  await expect(latest.take(Promise.resolve(), () => {
    throw new Error("unusable");
  })).rejects.toThrow("unusable");
});
