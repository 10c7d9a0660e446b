// SPDX-License-Identifier: BSD-3-Clause
// The monitor answers when it likes, while somebody chooses, types and pushes.
import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Diagnostic } from "../../src/feed/messages";
import type { Machine } from "../../src/feed/parts";
import { Refusal } from "../../src/feed/api";
import { Workshop } from "../../src/program/workshop.svelte";
import { Questions } from "../fixture/answers";
import { live, runs } from "../fixture/fake_live.svelte";

const monitor = vi.hoisted(() => ({ questions: undefined as unknown as Questions }));
vi.mock("../../src/feed/api", async (original) => {
  monitor.questions = new (await import("../fixture/answers")).Questions();
  const operations = ["listPrograms", "listPushed", "readProgram", "readPushed", "check", "push", "cancelPush"];
  return { ...(await original<object>()), ...Object.fromEntries(operations.map((name) => [name, monitor.questions.operation(name)])) };
});
vi.mock("../../src/model/live.svelte", () => import("../fixture/fake_live.svelte"));
const ui = vi.hoisted(() => ({ editorOpen: false }));
vi.mock("../../src/lib/ui.svelte", () => ({ ui }));

const { questions } = monitor;
const program = (name: string) => [{ path: `${name}.bhdl`, text: `${name}'s text` }];
const A = program("a");
const B = program("b");
const OFFICE = { name: "office.bhdl", hash: "0ff1ce", files: program("office") };
const machine = (state: string): Machine => ({ start_state: state, states: [], transitions: [] });
const problem = (file: string, message: string): Diagnostic => ({ file, line: 1, column: 1, severity: "error", code: "a/b", message, hint: "" });
const good = (name: string) => ({ ok: true, hash: `${name}'s hash`, diagnostics: [], machine: machine(name), changes: [`+ state '${name}'`] });
const result = (hash: string) => ({ id: "1", hash, state: "running", steps: [], trial: null, replies: [] });

let workshop: Workshop;
beforeEach(() => {
  questions.asked = [];
  live.reset();
  live.robots = [runs("io", OFFICE)];
  ui.editorOpen = false;
  workshop = new Workshop();
});

const type = (text: string) => workshop.bench.edit(workshop.bench.files[workshop.bench.open]!.path, text);
const onBench = () => ({ name: workshop.bench.chosen, text: workshop.bench.files[0]?.text });
const question = () => workshop.pushing.question;

/** Chooses a shipped program, which comes at once. */
async function bring(name: string): Promise<void> {
  void workshop.choose(`${name}.bhdl`);
  await questions.of("readProgram").answer(program(name));
}

/** The program on the bench is checked, and its push waits for the click that confirms it. */
async function askFor(name: string): Promise<void> {
  void workshop.ask([]);
  await questions.of("check").answer(good(name));
}

describe("of two programs that are chosen one after the other", () => {
  beforeEach(() => {
    void workshop.choose("a.bhdl");
    void workshop.choose("b.bhdl");
  });

  it("the second stands on the bench and is pushed, though the first comes last", async () => {
    await questions.of("readProgram", 1).answer(B);
    await questions.of("readProgram", 0).answer(A);
    expect(onBench()).toEqual({ name: "b.bhdl", text: "b's text" });
    await askFor("b");
    void workshop.push();
    expect(questions.of("push").told[0]).toEqual(B);
  });
  it("the second stands on the bench though the first is refused afterwards, and nobody hears of that", async () => {
    await questions.of("readProgram", 1).answer(B);
    await questions.of("readProgram", 0).refuse(new Refusal("There is no such program."));
    expect(onBench()).toEqual({ name: "b.bhdl", text: "b's text" });
    expect(workshop.attempts.failure).toBeUndefined();
  });
  it("the first does not come onto the bench under the second's name meanwhile", async () => {
    await questions.of("readProgram", 0).answer(A);
    expect(workshop.bench.files).toEqual([]);
    expect(workshop.attempts.busy).toBe(true);
    await questions.of("readProgram", 1).answer(B);
    expect(workshop.attempts.busy).toBe(false);
  });
});

describe("while a program is on its way", () => {
  beforeEach(async () => {
    await bring("a");
    void workshop.choose("b.bhdl");
  });

  it("what somebody types stays, under the name that it belongs to, and the page says so", async () => {
    type("a's text, edited");
    await questions.of("readProgram").answer(B);
    expect(onBench()).toEqual({ name: "a.bhdl", text: "a's text, edited" });
    expect(workshop.attempts.failure).toMatch(/was not opened.*edited/);
    expect(workshop.attempts.busy).toBe(false);
  });
  it("the one before it is neither checked nor asked about under its name", () => {
    void workshop.check();
    void workshop.ask([]);
    expect(questions.count("check")).toBe(0);
    expect(question()).toBeUndefined();
  });
  it("what the robot runs may be put on the bench instead", async () => {
    workshop.takeRunning();
    await questions.of("readProgram").answer(B);
    expect(onBench()).toEqual({ name: "", text: "office's text" });
  });
  it("the names and texts that others put on the bench may be asked about", async () => {
    workshop.takeChanged(OFFICE.files, 0);
    await askFor("office");
    expect(question()?.draft.files).toEqual(OFFICE.files);
  });
  it("its name is taken back where it is refused", async () => {
    expect(onBench().name).toBe("b.bhdl");
    await questions.of("readProgram").refuse(new Refusal("There is no such program."));
    expect(onBench()).toEqual({ name: "a.bhdl", text: "a's text" });
    expect(workshop.attempts.failure).toBe("There is no such program.");
  });
});

describe("a check", () => {
  beforeEach(() => bring("a"));

  it("says nothing of what is typed meanwhile", async () => {
    void workshop.check();
    type("a's text, edited");
    await questions.of("check").answer({ ok: false, hash: "", diagnostics: [problem("a.bhdl", "wrong")] });
    expect(workshop.checks.verdict).toBeUndefined();
    expect(workshop.checks.diagnostics).toEqual([]);
  });
  it("that was asked for earlier does not overrule a later one", async () => {
    void workshop.check();
    void workshop.check();
    await questions.of("check", 1).answer(good("a"));
    await questions.of("check", 0).answer({ ok: false, hash: "", diagnostics: [problem("a.bhdl", "wrong")] });
    expect(workshop.checks.verdict?.ok).toBe(true);
  });
  it("draws no machine for another program", async () => {
    void workshop.check();
    await questions.of("check").answer(good("a"));
    expect(workshop.checks.machine?.start_state).toBe("a");
    type("broken");
    expect(workshop.checks.machine?.start_state).toBe("a");
    await bring("b");
    expect(workshop.checks.machine).toBeUndefined();
  });
  it("tells differences from what runs, and none from what does not run any more", async () => {
    void workshop.check();
    await questions.of("check").answer(good("a"));
    expect(workshop.checks.changes).toEqual(["+ state 'a'"]);
    live.robots = [runs("io", { ...OFFICE, hash: "0ther" })];
    expect(workshop.checks.changes).toBeUndefined();
    void workshop.preview();
    await questions.of("check").answer(good("a"));
    expect(workshop.checks.changes).toEqual(["+ state 'a'"]);
  });
});

describe("what the language server says of a file", () => {
  it("is not said of another program's file of that name", async () => {
    await bring("a");
    workshop.checks.typed.note("a.bhdl", [problem("a.bhdl", "wrong")]);
    type("a's text, edited");
    expect(workshop.checks.diagnostics).toHaveLength(1);
    workshop.takeChanged([{ path: "a.bhdl", text: "another" }], 0);
    expect(workshop.checks.diagnostics).toEqual([]);
  });
  it("stays where the file stays the same", async () => {
    await bring("a");
    workshop.checks.typed.note("a.bhdl", [problem("a.bhdl", "wrong")]);
    await bring("a");
    expect(workshop.checks.diagnostics).toHaveLength(1);
  });
});

describe("the question whether to push", () => {
  beforeEach(() => bring("a"));

  it("is of one program, with its text, its hash and its robots", async () => {
    void workshop.ask(["io"]);
    await questions.of("check").answer(good("a"));
    expect(question()).toMatchObject({ draft: { chosen: "a.bhdl", files: A }, hash: "a's hash", targets: ["io"] });
  });
  it("is not put of a program that was left while it was checked", async () => {
    void workshop.ask([]);
    void workshop.choose("b.bhdl");
    await questions.of("check").answer(good("a"));
    expect(question()).toBeUndefined();
    await questions.of("readProgram").answer(B);
    expect(question()).toBeUndefined();
  });
  it("is not put of a text that was edited while it was checked", async () => {
    void workshop.ask([]);
    type("a's text, edited");
    await questions.of("check").answer(good("a"));
    expect(question()).toBeUndefined();
  });
  it("is taken back as soon as somebody edits what it is about, so that nothing unseen is pushed", async () => {
    await askFor("a");
    type("a's text, edited");
    expect(question()).toBeUndefined();
    void workshop.push();
    expect(questions.count("push")).toBe(0);
  });
  it("is taken back as soon as another program is chosen", async () => {
    await askFor("a");
    void workshop.choose("b.bhdl");
    expect(question()).toBeUndefined();
    void workshop.push();
    expect(questions.count("push")).toBe(0);
  });
});

describe("a push", () => {
  beforeEach(async () => {
    await bring("a");
    await askFor("a");
    void workshop.push();
  });

  it("is told under its own name, whatever has come onto the bench meanwhile", async () => {
    await bring("b");
    await questions.of("push").answer(result("a's hash"));
    expect(live.pushed).toHaveBeenCalledWith(expect.objectContaining({ hash: "a's hash" }), A, []);
    expect(onBench()).toEqual({ name: "b.bhdl", text: "b's text" });
  });
  it("is told with the text that was sent, whatever somebody types meanwhile", async () => {
    type("a's text, edited");
    await questions.of("push").answer(result("a's hash"));
    expect(live.pushed).toHaveBeenCalledWith(expect.anything(), A, []);
    expect(onBench().text).toBe("a's text, edited");
  });
  it("that is refused shows its mistakes", async () => {
    await questions.of("push").refuse(new Refusal("It has errors.", [problem("a.bhdl", "wrong")]));
    expect(workshop.checks.errors).toHaveLength(1);
    expect(workshop.attempts.failure).toBe("It has errors.");
  });
  it("that is refused shows no mistakes of another text", async () => {
    type("a's text, edited");
    await questions.of("push").refuse(new Refusal("It has errors.", [problem("a.bhdl", "wrong")]));
    expect(workshop.checks.errors).toEqual([]);
    expect(workshop.attempts.failure).toBe("It has errors.");
  });
  it("is gone back on with what ran before, whatever stands on the bench", async () => {
    await questions.of("push").answer(result("a's hash"));
    await bring("b");
    void workshop.goBack("1", "a's hash");
    expect(questions.of("push").told).toEqual([OFFICE.files, [], { replaces: "a's hash" }]);
    await questions.of("push").refuse(new Refusal("It has errors.", [problem("office.bhdl", "wrong")]));
    expect(workshop.checks.errors).toEqual([]);
  });
});

describe("restoring a program", () => {
  beforeEach(async () => {
    await bring("a");
    void workshop.list();
    await questions.of("listPrograms").answer([]);
    await questions.of("listPushed").answer([{ program: "c.bhdl", hash: "c", author: "", pushed_ns: 1, id: "1", targets: [] }]);
    void workshop.restore("c");
  });

  it("asks whether to push it", async () => {
    await questions.of("readPushed").answer(program("c"));
    await questions.of("check").answer(good("c"));
    expect(question()?.draft).toMatchObject({ chosen: "c", files: program("c") });
  });
  it("leaves what somebody types meanwhile, and asks nothing", async () => {
    type("a's text, edited");
    await questions.of("readPushed").answer(program("c"));
    expect(onBench()).toEqual({ name: "a.bhdl", text: "a's text, edited" });
    expect(questions.count("check")).toBe(0);
  });
  it("asks nothing of a program that is chosen meanwhile", async () => {
    void workshop.choose("b.bhdl");
    await questions.of("readPushed").answer(program("c"));
    await questions.of("readProgram").answer(B);
    expect(onBench()).toEqual({ name: "b.bhdl", text: "b's text" });
    expect(questions.count("check")).toBe(0);
    expect(question()).toBeUndefined();
  });
});

describe("showing a place of a program that ran before", () => {
  const place = { file: "c.bhdl", line: 3, column: 1 };
  beforeEach(async () => {
    await bring("a");
    void workshop.showRunning(place, "c");
  });

  it("puts it on the bench", async () => {
    await questions.of("readPushed").answer(program("c"));
    expect(onBench()).toEqual({ name: "", text: "c's text" });
    expect([workshop.bench.place, ui.editorOpen]).toEqual([place, true]);
  });
  it("leaves what somebody types meanwhile", async () => {
    type("a's text, edited");
    await questions.of("readPushed").answer(program("c"));
    expect(onBench()).toEqual({ name: "a.bhdl", text: "a's text, edited" });
  });
  it("leaves the program that is chosen meanwhile, and does not open the editor on it", async () => {
    void workshop.choose("b.bhdl");
    await questions.of("readProgram").answer(B);
    await questions.of("readPushed").answer(program("c"));
    expect(onBench()).toEqual({ name: "b.bhdl", text: "b's text" });
    expect([workshop.bench.place, ui.editorOpen]).toEqual([undefined, false]);
  });
  it("puts what runs now on the bench where the monitor does not know it", async () => {
    await questions.of("readPushed").refuse(new Refusal("No such program."));
    expect(onBench().text).toBe("office's text");
  });
});

describe("what the editor tells", () => {
  it("goes into the file that it shows, though another is opened just then", async () => {
    workshop.takeChanged([...A, ...B], 0);
    workshop.bench.open = 1;
    workshop.bench.edit("a.bhdl", "typed last");
    expect(workshop.bench.files).toEqual([{ path: "a.bhdl", text: "typed last" }, ...B]);
  });
});

describe("the list of pushes", () => {
  const push = (id: string) => ({ program: id, hash: id, author: "", pushed_ns: 1, id, targets: [] });

  it("is the newest that was asked for, whichever comes last", async () => {
    void workshop.list();
    void workshop.library.refreshHistory();
    await questions.of("listPrograms").answer([]);
    await questions.of("listPushed", 1).answer([push("new")]);
    await questions.of("listPushed", 0).answer([push("old")]);
    expect(workshop.library.history.map(({ id }) => id)).toEqual(["new"]);
    expect(workshop.attempts.busy).toBe(false);
  });
});
