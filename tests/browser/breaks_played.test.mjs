// SPDX-License-Identifier: BSD-3-Clause
// Break points of a played team: set by hand and by key, listed, stopped at, stepped from, and locks let through.
import assert from "node:assert/strict";
import { test } from "node:test";
import { loadAxe, violations } from "./axe.mjs";
import { playedTab, startFixture } from "./tab.mjs";

const tab = playedTab({ ahead: 5 }, { viewport: { width: 1920, height: 1080 } });
const { at, row, until, untilIs, untilRow } = tab;
const press = (key) => tab.page.keyboard.press(key);
const arrow = (name) => at("machine").locator(`[data-arrow='${name}']`);
const untilArrow = (name, kind) => until(([of, wanted]) => (document.querySelector(`[data-testid=machine] [data-arrow='${of}']`)?.dataset.break ?? "") === wanted, [name, kind]);
const untilState = (name, kind) => until(([of, wanted]) => (document.querySelector(`[data-testid=state-${of}]`)?.dataset.break ?? "") === wanted, [name, kind]);
const choose = (name) => at("break-choice").getByRole("button", { name, exact: true }).click();
const untilSaid = (testid, words) => at(testid).filter({ hasText: words }).waitFor();
const setAt = (name, point) => tab.api("/api/breaks", { order: "set", targets: [name], points: [point], author: "Anna" });
const focused = () => tab.page.evaluate(() => document.activeElement.dataset.arrow ?? document.activeElement.dataset.state);

test("a click on a state shows what may be set there, and a press of that sets it, changes it and takes it off", async () => {
  await at("state-grab_trash").click();
  await choose("Stop");
  await untilState("grab_trash", "stop");
  assert.match(await at("state-grab_trash").getAttribute("aria-label"), /^State grab_trash, entering it stops the robot$/);
  await choose("Stop team");
  await untilState("grab_trash", "stop_team");
  await choose("Lock");
  await untilState("grab_trash", "lock");
  await at("state-grab_trash").locator("[data-mark=lock]").waitFor();
  await choose("Lock");
  await untilState("grab_trash", "");
  await at("state-grab_trash").click();
  await at("break-choice").waitFor({ state: "detached" });
});

test("by keys alone: b on a state, and on each arrow that leaves it", async () => {
  await at("state-move_to_trash").focus();
  await press("b");
  await untilState("move_to_trash", "stop");
  await press("b");
  await untilState("move_to_trash", "");
  await press("PageDown");
  const first = await focused();
  assert.match(first, /^move_to_trash → /);
  await press("PageDown");
  assert.notEqual(await focused(), first);
  await press("PageUp");
  assert.equal(await focused(), first);
  await press("b");
  await untilArrow(first, "stop");
  assert.match(await arrow(first).getAttribute("aria-label"), /^From move_to_trash to \w+, stops the robot$/);
  await press("Enter");
  await choose("Lock");
  await untilArrow(first, "lock");
  await choose("Lock");
  await untilArrow(first, "");
  await arrow(first).focus();
  await press("Enter");
  await press("ArrowLeft");
  assert.equal(await focused(), "move_to_trash");
  await tab.page.evaluate(() => document.activeElement.blur());
});

test("b says what it wants where nothing is pointed at", async () => {
  await tab.page.mouse.move(5, 5);
  await press("b");
  await untilSaid("trouble", "put the pointer or the keyboard on a state or an arrow");
  await at("trouble").getByRole("button", { name: "Dismiss" }).click();
});

test("while the list is open a click sets a break point, and each is taken off from there", async () => {
  const list = at("break-list");
  await press("B");
  await list.getByText("io has none.").waitFor();
  await at("state-backup1").click();
  await arrow("grab_trash → backup1").locator(".reach").click({ force: true });
  await list.locator("[data-change='on entering backup1'][data-kind=stop]").waitFor();
  await list.locator("[data-change='grab_trash → backup1'][data-kind=stop]").waitFor();
  assert.match(await at("machine-breaks").innerText(), /Break points\s2/);
  await at("state-backup1").click({ modifiers: ["Shift"] });
  await at("break-choice").waitFor();
  await at("machine-detail").getByRole("button", { name: "Close" }).click();
  await list.getByRole("button", { name: "Take off: on entering backup1" }).click();
  await untilState("backup1", "");
  await list.getByRole("button", { name: "Take all off" }).click();
  await list.getByText("io has none.").waitFor();
});

test("for the team they are set at every robot", async () => {
  const list = at("break-list");
  await list.getByRole("button", { name: "team" }).click();
  await at("state-drop_trash").click();
  await untilState("drop_trash", "stop");
  await row("callisto").getByRole("button").first().click();
  await untilState("drop_trash", "stop");
  await list.getByRole("button", { name: "Take all off" }).click();
  await untilState("drop_trash", "");
  await list.getByRole("button", { name: "callisto" }).click();
  await row("io").getByRole("button").first().click();
  await untilState("drop_trash", "");
  await press("B");
  await list.waitFor({ state: "detached" });
});

test("a robot stops there, and its row, Why and Timeline say why", async () => {
  // One that entered a state while it had a break point above still stands there.
  await tab.api("/api/command", { kind: "resume" });
  await setAt("io", { to: "move_to_trash" });
  await untilRow("io", "data-stopped", "true");
  // "at" with both states where the page has heard the change of state already.
  await untilSaid("break-io", /^stopped (at \w+ →|on entering) move_to_trash \(Anna's break point\)$/);
  // Not before: a robot that had stopped further on would wait there.
  await setAt("io", { from: "grab_trash", to: "backup1", kind: "lock" });
  await untilSaid("machine-break", "stopped");
  await at("why").locator("li.newest [data-stopped-by]").filter({ hasText: "stopped io here: break point on entering move_to_trash, set by Anna" }).waitFor();
  await at("timeline").locator("[data-event=stopped] title").filter({ hasText: /^io stopped (at \w+ →|on entering) move_to_trash/ }).first().waitFor({ state: "attached" });
  assert.equal(await at("timeline").locator("[data-event=held]").count(), 0);
  assert.equal(await row("io").getByRole("button", { name: "Hold" }).count(), 0);
  await tab.page.locator("[aria-live=polite]").filter({ hasText: /io stopped at/ }).waitFor({ state: "attached" });
});

test("with a robot that stands there the page has no violation, dark or light", async () => {
  for (const colorScheme of ["light", "dark"]) {
    const page = await tab.browser.newPage({ viewport: { width: 1366, height: 768 }, colorScheme });
    await page.goto(tab.url);
    await page.getByTestId("break-io").waitFor();
    await loadAxe(page);
    await page.keyboard.press("B");
    await page.getByTestId("break-list").locator("[data-kind=lock]").waitFor();
    await page.getByTestId("state-grab_trash").focus();
    await page.keyboard.press("Enter");
    await page.getByTestId("break-choice").waitFor();
    assert.deepEqual(await violations(page), [], colorScheme);
    await page.close();
  }
});

test("n steps into the next state, where it stands again", async () => {
  await press("n");
  await untilSaid("break-io", "stepped into grab_trash");
  await untilRow("io", "data-held", "true");
  await at("why").locator("li.newest [data-stopped-by]").filter({ hasText: "a step, ordered by operator" }).waitFor();
});

test("it goes on to the lock, waits there, and is let through", async () => {
  await row("io").getByRole("button", { name: "Go on" }).click();
  await untilRow("io", "data-held", "false");
  await untilSaid("break-io", /^waits at the lock grab_trash → backup1 for \d/);
  const untilWaits = (wanted) => until((waits) => document.querySelector("[data-testid=machine] [data-arrow='grab_trash → backup1']")?.dataset.waits === waits, wanted);
  await untilWaits("true");
  await row("io").getByRole("button", { name: "Let through" }).click();
  await untilWaits("false");
  await untilArrow("grab_trash → backup1", "lock");
  await until(() => document.querySelector("[data-testid=machine] [data-current=true]")?.dataset.state !== "grab_trash");
});

test("one that an operator holds refuses to step, and says why", async () => {
  await row("ganymede").getByRole("button").first().click();
  await press("h");
  await untilRow("ganymede", "data-held", "true");
  assert.equal(await row("ganymede").getByRole("button", { name: "Step" }).count(), 0);
  await press("n");
  await untilSaid("break-complaint", "ganymede refused: ganymede is held by an operator, not at a break point: resume it first.");
  await at("break-complaint").getByRole("button", { name: "Dismiss" }).click();
  await at("break-complaint").waitFor({ state: "detached" });
  await row("ganymede").getByRole("button", { name: "Resume" }).click();
  await untilRow("ganymede", "data-held", "false");
});

test("a break point of the team stops the others, who step as well", async () => {
  await tab.api("/api/breaks", { order: "clear" });
  // It may have come round to where it stopped before.
  await tab.api("/api/command", { kind: "resume", targets: ["io"] });
  await tab.api("/api/breaks", { order: "set", targets: ["io"], points: ["wander_for_trash", "wander_for_trashcan", "move_to_trash", "move_to_trashcan", "backup1", "backup2"].map((to) => ({ to, kind: "stop_team" })) });
  await untilSaid("break-callisto", /^stopped by io's break point on entering \w+, set by operator$/);
  await tab.api("/api/breaks", { order: "clear" });
  await press("N");
  // A robot that steps goes on for as long as its state lasts, which may be over before the page draws it.
  await until(() => {
    const row = document.querySelector("[data-testid=team-row-callisto]");
    return row?.dataset.stopped === "false" || /stepped into/.test(row?.querySelector("[data-testid=break-callisto]")?.textContent);
  });
});

test("on a phone it is said on the robot's button", async () => {
  const { url, stop } = await startFixture({ ahead: 5, stopping: "io" });
  const page = await tab.browser.newPage({ viewport: { width: 390, height: 844 } });
  await page.goto(url);
  await page.getByTestId("strip-io").filter({ hasText: "is stopped" }).waitFor({ timeout: 120_000 });
  await page.close();
  await stop();
});

tab.testComplaints();
