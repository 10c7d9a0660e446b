// SPDX-License-Identifier: BSD-3-Clause
// Numbers are moved faster than robots answer.
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Refusal } from "../../src/feed/api";
import { ProgramReply_Constants } from "../../src/feed/messages";
import { answerWords } from "../../src/gains/answer_words";
import { Tuner } from "../../src/gains/tuner.svelte";
import { workshop } from "../../src/program/workshop.svelte";
import { Questions } from "../fixture/answers";
import { catalog } from "../fixture/catalogs";
import { live, runs } from "../fixture/fake_live.svelte";

const monitor = vi.hoisted(() => ({ questions: undefined as unknown as Questions }));
vi.mock("../../src/feed/api", async (original) => {
  monitor.questions = new (await import("../fixture/answers")).Questions();
  const operations = ["push", "readPush"];
  return { ...(await original<object>()), ...Object.fromEntries(operations.map((name) => [name, monitor.questions.operation(name)])) };
});
vi.mock("../../src/model/live.svelte", () => import("../fixture/fake_live.svelte"));
const ui = vi.hoisted(() => ({ editorOpen: false }));
vi.mock("../../src/lib/ui.svelte", () => ({ ui }));

const { questions } = monitor;
const text = (noise: number, comment = "much") => `motor_schemas:\n  combine_forces: name: "c" inputs: "noise" "robot" gains: ${noise} 2 ; ${comment}\n  end\nend\n`;
const files = (noise: number, comment?: string) => [{ path: "a.bhdl", text: text(noise, comment) }];
const program = (noise: number) => ({ name: "a.bhdl", hash: `hash of ${noise}`, files: files(noise) });
const NOISE = { key: "combine_forces c gains noise" };
const ROBOT = { key: "combine_forces c gains robot" };

let tuner: Tuner;
function run(noise: number): void {
  live.robots = [{ ...runs("io", program(noise)), catalog } as ReturnType<typeof runs>];
}
const reply = (status: string, message = "") => ({ robot: "io", status, message, hash: "", running_hash: "", swap_tick_us: 0, kept_variables: [], diagnostics: [] });
const result = (noise: number, state = "done", status = "running") => ({ id: `push of ${noise}`, hash: `hash of ${noise}`, state, steps: [], trial: null, replies: [reply(status)] });
const rest = () => vi.advanceTimersByTimeAsync(500);
const stands = () => tuner.valueOf(tuner.tunables.find(({ key }) => key === NOISE.key)!);
const pushed = (index = -1) => (questions.of("push", index).told[0] as ReturnType<typeof files>)[0]!.text;

/** The robot takes what was pushed and says so. */
async function take(noise: number): Promise<void> {
  await questions.of("push").answer(result(noise));
  run(noise);
  await vi.advanceTimersByTimeAsync(100);
}

beforeEach(() => {
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout", "Date"] });
  questions.asked = [];
  live.reset();
  ui.editorOpen = false;
  workshop.bench.put({ chosen: "", files: [], edited: false });
  run(1);
  tuner = new Tuner();
});
afterEach(() => vi.useRealTimers());

describe("a number that is moved", () => {
  it("is pushed once the hand rests, in its place, in the place of what runs, with the reason", async () => {
    tuner.move(NOISE, 1.2);
    await vi.advanceTimersByTimeAsync(200);
    tuner.move(NOISE, 1.5);
    await vi.advanceTimersByTimeAsync(300);
    expect(questions.count("push")).toBe(0);
    await rest();
    expect(questions.count("push")).toBe(1);
    expect(questions.of("push").told).toEqual([files(1.5), [], { replaces: "hash of 1", reason: "c · gain of noise 1 → 1.5" }]);
  });
  it("is not sent while the hand moves it again, though a push has ended meanwhile", async () => {
    tuner.move(NOISE, 1.5);
    await rest();
    tuner.move(NOISE, 1.6);
    await take(1.5);
    expect(questions.count("push")).toBe(1);
    await rest();
    expect(pushed()).toBe(text(1.6));
  });
  it("goes to no robot that is out of service or silent, and where none is left it goes nowhere", async () => {
    const io = live.robots[0]!;
    const out = { ...runs("ganymede", program(1)), catalog } as typeof io;
    live.robots = [io, { ...out, state: { ...out.state!, value: { ...out.state!.value, out_of_service: true } } }];
    expect(tuner.targets).toEqual(["io"]);
    expect(tuner.program?.hash).toBe("hash of 1");
    live.robots = [live.robots[1]!];
    expect(tuner.program).toBeUndefined();
  });
  it("waits while a push is under way, and then the last value counts, put into what runs by then", async () => {
    tuner.move(NOISE, 1.5);
    await rest();
    tuner.move(NOISE, 1.6);
    await rest();
    tuner.move(NOISE, 1.7);
    await rest();
    expect(questions.count("push")).toBe(1);
    await take(1.5);
    expect(questions.count("push")).toBe(2);
    expect(pushed()).toBe(text(1.7));
    expect(questions.of("push").told[2]).toMatchObject({ replaces: "hash of 1.5" });
  });
  it("waits for the whole way of a push, as for its canary", async () => {
    tuner.move(NOISE, 1.5);
    await rest();
    await questions.of("push").answer(result(1.5, "running"));
    tuner.move(NOISE, 1.7);
    await rest();
    expect([questions.count("push"), questions.count("readPush")]).toEqual([1, 1]);
    await questions.of("readPush").answer(result(1.5));
    run(1.5);
    await vi.advanceTimersByTimeAsync(100);
    expect(questions.count("push")).toBe(2);
  });
  it("goes with another that is moved meanwhile", async () => {
    tuner.move(NOISE, 1.5);
    tuner.move(ROBOT, 3);
    await rest();
    expect(pushed()).toBe(text(1.5).replace(" 2 ;", " 3 ;"));
  });
});

describe("the slider", () => {
  it("stands where the hand put it until the robots answer, and then where they run it", async () => {
    tuner.move(NOISE, 1.5);
    expect(stands()).toBe(1.5);
    await rest();
    expect(stands()).toBe(1.5);
    await take(1.5);
    expect([stands(), tuner.isBusy]).toEqual([1.5, false]);
    run(1); // it went back
    expect(stands()).toBe(1);
  });
  it("goes back where the push is refused, and says why", async () => {
    tuner.move(NOISE, 1.5);
    await rest();
    await questions.of("push").refuse(new Refusal("io runs another program."));
    expect([stands(), tuner.answerOf(NOISE.key)?.failure, tuner.last]).toEqual([1, "io runs another program.", undefined]);
  });
  it("goes back where the robot refuses, and leaves the draft alone", async () => {
    tuner.move(NOISE, 1.5);
    await rest();
    await questions.of("push").answer(result(1.5, "failed", "rejected"));
    expect([stands(), tuner.last, workshop.bench.files]).toEqual([1, undefined, []]);
  });
});

describe("undo", () => {
  it("pushes the number that ran before, once for each move", async () => {
    tuner.move(NOISE, 1.5);
    await rest();
    await take(1.5);
    tuner.undo();
    await rest();
    expect(pushed()).toBe(text(1));
    await take(1);
    expect(tuner.last).toBeUndefined();
  });
  it("brings back every digit that stood there, and may be tried again where it was refused", async () => {
    run(0.0625);
    tuner.move(NOISE, 1.5);
    await rest();
    await take(1.5);
    tuner.undo();
    await rest();
    expect(pushed()).toBe(text(0.0625));
    await questions.of("push").answer(result(0.0625, "done", "refused"));
    await vi.advanceTimersByTimeAsync(100);
    expect(tuner.last?.from).toBe(0.0625);
  });
});

describe("the draft", () => {
  async function tune(): Promise<void> {
    tuner.move(NOISE, 1.5);
    await rest();
    await take(1.5);
  }
  it("is what was pushed, where there was none", async () => {
    await tune();
    expect(workshop.bench.draft).toMatchObject({ files: files(1.5), edited: true });
  });
  it("has the number in its place, and what somebody wrote stays", async () => {
    workshop.bench.put({ chosen: "", files: files(1, "written by hand"), edited: true });
    await tune();
    expect(workshop.bench.files).toEqual(files(1.5, "written by hand"));
  });
  it("is left alone while somebody types in it", async () => {
    workshop.bench.put({ chosen: "", files: files(1, "being written"), edited: true });
    ui.editorOpen = true;
    await tune();
    expect(workshop.bench.files).toEqual(files(1, "being written"));
  });
  const replied = async (status: number) => {
    live.hear("/io/program_reply", { id: "push of 1.5", robot: "io", status });
    await vi.advanceTimersByTimeAsync(100);
  };
  async function goBack(): Promise<void> {
    run(1);
    await replied(ProgramReply_Constants.ROLLED_BACK);
  }
  it("goes back to what runs when the robots do, and so does undo", async () => {
    workshop.bench.put({ chosen: "", files: files(1, "written by hand"), edited: true });
    await tune();
    await goBack();
    expect([workshop.bench.files, tuner.last]).toEqual([files(1, "written by hand"), undefined]);
  });
  it("goes back though the editor shows it, where nobody typed since", async () => {
    await tune();
    ui.editorOpen = true;
    await goBack();
    expect([workshop.bench.files, live.trouble]).toEqual([files(1), undefined]);
  });
  it("that somebody types in keeps the number, and the page says what runs", async () => {
    await tune();
    ui.editorOpen = true;
    workshop.bench.edit("a.bhdl", text(1.5, "being written"));
    await goBack();
    expect(workshop.bench.files).toEqual(files(1.5, "being written"));
    expect(live.trouble).toBe("The robots went back. The draft still has c · gain of noise 1.5, where the robots run 1.");
  });
  it("keeps a number that somebody wrote in its place, and one that the robots have confirmed", async () => {
    await tune();
    workshop.bench.edit("a.bhdl", text(1.7));
    await goBack();
    expect(workshop.bench.files).toEqual(files(1.7));
    workshop.bench.put({ chosen: "", files: [], edited: false });
    await tune();
    await replied(ProgramReply_Constants.CONFIRMED);
    await goBack();
    expect(workshop.bench.files).toEqual(files(1.5));
  });
  it("of another program that lacks the number is left alone", async () => {
    const other = [{ path: "b.bhdl", text: "states:\nend\n" }];
    workshop.bench.put({ chosen: "b.bhdl", files: other, edited: false });
    await tune();
    expect(workshop.bench.draft).toEqual({ chosen: "b.bhdl", files: other, edited: false });
  });
});

describe("the answer", () => {
  const answer = (status: string, message = "") => answerWords({ pushId: "1", replies: [reply(status, message)] }, undefined);

  it("says what the robots do with the number", () => {
    expect([answer("running").words, answer("confirmed").words, answer("received").words]).toEqual(["runs, on probation", "taken", "is being built"]);
    expect(answer("rolled_back", "it overran its tick")).toEqual({ words: "io went back: it overran its tick", kind: "alarm" });
    expect(answer("no_answer").words).toBe("io did not answer");
  });
});
