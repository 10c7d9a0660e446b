// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, expect, it, vi } from "vitest";
import { Instructor } from "../../src/model/instructor.svelte";
import type { Questions } from "../fixture/answers";
import { live } from "../fixture/fake_live.svelte";

const monitor = vi.hoisted(() => ({ questions: undefined as unknown as Questions }));
vi.mock("../../src/feed/api", async () => {
  monitor.questions = new (await import("../fixture/answers")).Questions();
  return { orderSimulation: monitor.questions.operation("order") };
});
vi.mock("../../src/model/live.svelte", () => import("../fixture/fake_live.svelte"));

const { questions } = monitor;
const orders = () => questions.asked.map(({ told }) => told);
let instructor: Instructor;
beforeEach(() => {
  questions.asked = [];
  live.reset();
  live.simulation = { value: { simulation: "office-1" }, received_ms: 0 };
  instructor = new Instructor();
});

it("tells the simulation's own answer, or its reason", async () => {
  void instructor.give({ order: "pause" });
  await questions.of("order").answer({ text: "paused the simulation" });
  void instructor.give({ order: "pause" });
  await questions.of("order").refuse(new Error("the simulation is paused already."));
  expect(orders()).toEqual([["office-1", { order: "pause" }], ["office-1", { order: "pause" }]]);
  expect(instructor.answers.map(({ done, words }) => [done, words])).toEqual([
    [false, "the simulation is paused already."],
    [true, "paused the simulation"],
  ]);
});

it("gives no order where no simulation is heard, and says so", async () => {
  live.known_present_ms = 2001;
  expect(await instructor.give({ order: "pause" })).toBe(false);
  expect(orders()).toEqual([]);
  expect(instructor.answers[0]?.words).toBe("No simulation is heard any more.");
});

it("moves a body on to the newest place, one order at a time", async () => {
  const io = { name: "io", kind: "robot", x_m: 1, y_m: 1, heading_rad: 0, held_by: "" };
  void instructor.moveTo("io", { x_m: 1.1, y_m: 1 });
  void instructor.moveTo("io", { x_m: 1.2, y_m: 1 });
  void instructor.moveTo("io", { x_m: 1.3, y_m: 1 });
  expect(orders()).toEqual([["office-1", { order: "move", subject: "io", x_m: 1.1, y_m: 1 }]]);
  expect(instructor.placeOf(io)).toEqual({ x_m: 1.3, y_m: 1 });
  await questions.of("order").answer({ text: "moved io" });
  expect(orders()[1]).toEqual(["office-1", { order: "move", subject: "io", x_m: 1.3, y_m: 1 }]);
  await questions.of("order").answer({ text: "moved io" });
  expect(orders().length).toBe(2);
  expect(instructor.placeOf(io)).toEqual({ x_m: 1, y_m: 1 });
});

it("a body stays where it is when its move is refused", async () => {
  void instructor.moveTo("io", { x_m: 0, y_m: 0 });
  void instructor.moveTo("io", { x_m: -1, y_m: 0 });
  await questions.of("order").refuse(new Error("io would stand in a wall."));
  expect(orders().length).toBe(1);
  expect(instructor.placeOf({ name: "io", kind: "robot", x_m: 1, y_m: 1, heading_rad: 0, held_by: "" })).toEqual({ x_m: 1, y_m: 1 });
});
