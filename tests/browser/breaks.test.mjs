// SPDX-License-Identifier: BSD-3-Clause
// Break points of a live robot: it stops in the tick of its change of state, steps, waits at locks, and goes on.
import assert from "node:assert/strict";
import { test } from "node:test";
import { liveTab } from "./tab.mjs";

const tab = liveTab();
const { api, at, row, until, untilRow } = tab;
const io = async () => (await api("/api/team")).robots.find(({ name }) => name === "io");
const untilSaid = (words) => at("break-io").filter({ hasText: words }).waitFor();
const states = () => at("machine").locator("[data-state]").evaluateAll((all) => all.map(({ dataset }) => dataset.state));

test("n holds a robot that drives at its next change of state", async () => {
  await row("io").getByRole("button").first().click();
  await at("machine").locator("[data-current=true]").waitFor();
  await tab.page.keyboard.press("n");
  await untilSaid(/^stepped into \w+$/);
  await untilRow("io", "data-held", "true");
  const { held, break_reason, breaks, x_m, y_m } = await io();
  assert.ok(held && breaks.stopped);
  assert.match(break_reason, /^stepped into \w+$/);
  const later = await io();
  assert.ok(Math.hypot(later.x_m - x_m, later.y_m - y_m) < 0.1, `it drove from ${x_m}, ${y_m} to ${later.x_m}, ${later.y_m}`);
});

test("it stops where a click has set a break point, says whose, and Why says so at that change", async () => {
  await tab.page.keyboard.press("B");
  const all = await states();
  for (const name of all) {
    await at(`state-${name}`).click();
    await tab.untilIs(`state-${name}`, "data-break", "stop");
  }
  await row("io").getByRole("button", { name: "Go on" }).click();
  await untilSaid(/^stopped at \w+ → \w+ \(\S+'s break point\)$/);
  const { breaks, transitions } = await io();
  assert.equal(breaks.points.length, all.length);
  const { number, from_state, to_state } = transitions.find(({ number }) => number === breaks.stopped_at);
  await untilSaid(`stopped at ${from_state} → ${to_state}`);
  // Where it has gone round the same states, the change stands in their one line, which counts the stops.
  await at("why").locator(`[data-testid=why-${number}] [data-stopped-by], [data-stops]`).first().waitFor();
  await at("timeline").locator("[data-event=stopped]").first().waitFor({ state: "attached" });
  await at("break-list").getByRole("button", { name: "Take all off" }).click();
  await at("break-list").getByText("io has none.").waitFor();
  await tab.page.keyboard.press("B");
});

test("at a lock it waits, until it is let through", async () => {
  const locked = (await states()).map((to) => ({ to, kind: "lock" }));
  await api("/api/breaks", { order: "set", targets: ["io"], points: locked });
  await until((count) => document.querySelectorAll("[data-testid=machine] [data-state][data-break=lock]").length === count, locked.length);
  const before = (await io()).transitions.at(-1).number;
  await row("io").getByRole("button", { name: "Go on" }).click();
  await untilSaid(/^waits at the lock \w+ → \w+ for /);
  assert.equal((await io()).transitions.at(-1).number, before, "no transition fired meanwhile");
  await row("io").getByRole("button", { name: "Let through" }).click();
  await until((number) => document.querySelector(`[data-testid="why-${number}"]`), before + 1);
});

test("without break points it goes on as before", async () => {
  await api("/api/breaks", { order: "clear" });
  await until(() => document.querySelectorAll("[data-testid=machine] [data-break]").length === 0);
  await untilRow("io", "data-stopped", "false");
  await untilRow("io", "data-held", "false");
  const { number } = (await io()).transitions.at(-1);
  await until((known) => Number(document.querySelector("[data-testid=why] li.newest")?.dataset.testid.slice("why-".length)) > known, number);
});

tab.testComplaints();
