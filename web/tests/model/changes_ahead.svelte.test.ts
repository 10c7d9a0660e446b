// SPDX-License-Identifier: BSD-3-Clause
// What is drawn of the chosen robot when its state changes, frame by frame.
import { beforeAll, expect, it, vi } from "vitest";
import type { Report } from "../../src/feed/feed_server";
import type { News } from "../../src/feed/portions";
import { state, T0_MS, transition } from "./told";

let report: (report: Report) => void;
/** The feed's thread, as the test plays it. */
class FakeWorker {
  onmessage: (event: { data: Report }) => void = () => {};
  constructor() {
    report = (data) => this.onmessage({ data });
  }
  postMessage() {}
}

const waiting: (() => void)[] = [];
const frame = () => waiting.splice(0).forEach((draw) => draw());
const page = new URL("http://monitor/");
vi.stubGlobal("location", page);
vi.stubGlobal("self", { location: page });
vi.stubGlobal("sessionStorage", { getItem: () => null });
vi.stubGlobal("matchMedia", () => ({ matches: false, addEventListener: () => {} }));
vi.stubGlobal("requestAnimationFrame", (draw: () => void) => waiting.push(draw));
vi.stubGlobal("Worker", FakeWorker);

const { live } = await import("../../src/model/live.svelte");

const news = (kind: string, message: unknown, robot = "io"): News => ({ topic: `/${robot}/${kind}`, message, received_ms: T0_MS, count: 1 });
const tell = (...told: News[]) => report({ kind: "batch", batch: { told_ms: T0_MS, news: told, dropped: 0 } });
const shown = () => ({ changes: live.changes.map(({ to_state }) => to_state), all: live.robot?.transitions.map(({ to_state }) => to_state), state: live.robot?.state?.value.state });
const until = (wanted: object) => vi.waitFor(() => expect(shown()).toEqual(wanted), { timeout: 20_000 });
/** Frame by frame, until that is shown. */
const framesUntil = (wanted: object) => vi.waitFor(() => (frame(), expect(shown()).toEqual(wanted)), { timeout: 20_000 });

beforeAll(async () => {
  live.start();
  tell(news("state", state({ state: "wander" })));
  await framesUntil({ changes: [], all: [], state: "wander" });
});

it("a change of its state comes before all else, which the next frame shows", async () => {
  tell(news("transition", transition(1, "grab")), news("state", state({ state: "grab", transitions: 1n })));
  await until({ changes: ["grab"], all: [], state: "wander" });
  await framesUntil({ changes: ["grab"], all: ["grab"], state: "grab" });
});

it("what else happens is drawn with all that is known", async () => {
  tell(news("transition", transition(2, "backup")), news("program", { hash: "b", files: [], states: [], transitions: [] }), news("state", state({ state: "backup", transitions: 2n })));
  await until({ changes: ["grab", "backup"], all: ["grab", "backup"], state: "backup" });
});

it("another robot's changes are not taken for its own", async () => {
  frame();
  tell(news("state", state({ robot: "callisto", state: "wander" }), "callisto"), news("transition", { ...transition(3, "wander"), robot: "io" }));
  await until({ changes: ["grab", "backup", "wander"], all: ["grab", "backup"], state: "backup" });
  live.chosen = "callisto";
  await framesUntil({ changes: [], all: [], state: "wander" });
});
