// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, describe, expect, it, vi } from "vitest";
import type { BreakAnswer, Breaks } from "../../src/feed/messages";
import { BreakOrders } from "../../src/model/break_orders.svelte";
import { rights } from "../../src/model/rights.svelte";
import type { Questions } from "../fixture/answers";
import { live, runs } from "../fixture/fake_live.svelte";
import { breaks, point } from "./told";

const monitor = vi.hoisted(() => ({ questions: undefined as unknown as Questions }));
vi.mock("../../src/feed/api", async () => {
  monitor.questions = new (await import("../fixture/answers")).Questions();
  return { command: monitor.questions.operation("command"), orderBreaks: monitor.questions.operation("breaks") };
});
vi.mock("../../src/model/live.svelte", () => import("../fixture/fake_live.svelte"));

const { questions } = monitor;
const ENTERING = { from: "", to: "grab" };
let orders: BreakOrders;
const robot = (name: string, changes: Partial<Breaks> = {}) =>
  ({ ...runs(name, { name: "a.bhdl", hash: "aaaa", files: [] }), breaks: { value: breaks({ robot: name, ...changes }), received_ms: 0 } });
const answers = (id: string, refused = ""): BreakAnswer[] => [{ id, refused }];
const asked = () => questions.asked.map(({ told }) => told);

beforeEach(() => {
  questions.asked = [];
  live.reset();
  live.robots = [robot("io"), robot("ganymede")];
  rights.told(true);
  orders = new BreakOrders();
});

describe("a break point", () => {
  it("is set for the chosen robot, or for the team", () => {
    orders.toggle(ENTERING);
    orders.forTeam = true;
    orders.toggle(ENTERING, "lock");
    expect(asked()).toEqual([["set", ["io"], [{ ...ENTERING, kind: "stop" }]], ["set", [], [{ ...ENTERING, kind: "lock" }]]]);
  });
  it("is taken off where it is one of that kind, and becomes one of another", () => {
    live.robots = [robot("io", { points: [point("", "grab")] })];
    orders.toggle(ENTERING);
    orders.toggle(ENTERING, "lock");
    expect(asked()).toEqual([["remove", ["io"], [ENTERING]], ["set", ["io"], [{ ...ENTERING, kind: "lock" }]]]);
  });
  it("of the team is taken off those that have it", () => {
    live.robots = [robot("io", { points: [point("", "grab")] }), robot("ganymede")];
    orders.forTeam = true;
    orders.remove(ENTERING);
    orders.clear();
    expect(asked()).toEqual([["remove", ["io"], [ENTERING]], ["clear", []]]);
  });
  it("that is gone is told to nobody, and the reader is told so", () => {
    orders.remove(ENTERING);
    expect(live.trouble).toBe("io no longer has the break point on entering grab: somebody may have taken it off.");
    orders.forTeam = true;
    orders.remove({ from: "wander", to: "grab" });
    expect(live.trouble).toBe("No robot has the break point wander → grab: somebody may have taken it off.");
    expect(asked()).toEqual([]);
  });
  it("is nothing that is sent where there is no robot, or no right", () => {
    live.robots = [];
    orders.toggle(ENTERING);
    live.robots = [robot("io")];
    rights.told(false);
    orders.toggle(ENTERING);
    orders.step("io");
    expect(asked()).toEqual([]);
    expect(live.trouble).toMatch(/^You may watch only\./);
  });
});

it("of a recording nothing is ordered, and the reader is told why", () => {
  live.playback = {};
  orders.toggle(ENTERING);
  orders.step();
  expect(asked()).toEqual([]);
  expect(live.trouble).toMatch(/^This is a recording: a recording cannot be stopped or steered\./);
});

it("one robot is let through or steps, or all step", () => {
  orders.letThrough("io", { from: "grab", to: "move" });
  orders.step("io");
  orders.step();
  expect(asked()).toEqual([["let_through", ["io"], [{ from: "grab", to: "move" }]], ["step", ["io"]], ["step", []]]);
});

describe("what robots answer", () => {
  const known = (later_ms: number) => (live.known_present_ms = Date.now() + later_ms);

  it("is not told where they do it", async () => {
    orders.step("io");
    await questions.of("command").answer({ id: "1" });
    live.robots = [robot("io", { answers: answers("1") })];
    orders.refresh();
    known(9000);
    expect(orders.complaint).toBeUndefined();
  });
  it("is told where they refuse, until the next order or until it is dismissed", async () => {
    const refuses = async (id: string) => {
      orders.step("io");
      await questions.of("command").answer({ id });
      live.robots = [robot("io", { answers: answers(id, "io is held by Anna, not at a break point: resume it first") })];
      orders.refresh();
    };
    await refuses("1");
    expect(orders.complaint).toBe("io refused: io is held by Anna, not at a break point: resume it first.");
    orders.clear();
    expect(orders.complaint).toBeUndefined();
    await questions.of("breaks").answer({ id: "2" });
    await refuses("3");
    orders.dismiss();
    expect(orders.complaint).toBeUndefined();
  });
  it("is missed where somebody does not, and counts though another order came after it", async () => {
    orders.step();
    await questions.of("command").answer({ id: "1" });
    live.robots = [robot("io", { answers: answers("1") }), robot("ganymede")];
    orders.refresh();
    live.robots = [robot("io", { answers: answers("of somebody else") }), robot("ganymede")];
    orders.refresh();
    expect(orders.complaint).toBeUndefined();
    known(3000);
    expect(orders.complaint).toBe("ganymede has not answered.");
  });
  it("is found though another operator's order was answered after it, before anybody looked", async () => {
    orders.step("io");
    await questions.of("command").answer({ id: "1" });
    live.robots = [robot("io", { answers: [...answers("1", "io is held by Anna"), ...answers("of somebody else")] })];
    orders.refresh();
    known(9000);
    expect(orders.complaint).toBe("io refused: io is held by Anna.");
  });
  it("is that of the newest order, though the monitor answered the earlier one last", async () => {
    orders.step("ganymede");
    orders.step("io");
    await questions.of("command", 1).answer({ id: "2" });
    await questions.of("command", 0).answer({ id: "1" });
    known(3000);
    expect(orders.complaint).toBe("io has not answered.");
  });
  it("is not waited for where the monitor did not take the order", async () => {
    orders.clear();
    await questions.of("breaks").refuse(new Error("The monitor does not answer."));
    expect(orders.complaint).toBe("The robots were not told: The monitor does not answer.");
    orders.dismiss();
    expect(orders.complaint).toBeUndefined();
  });
});
