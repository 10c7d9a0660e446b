// SPDX-License-Identifier: BSD-3-Clause
// Team, alarms, programs, referee and help of a played team: what is to be done, and doing it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab, startFixture } from "./tab.mjs";

const tab = playedTab({ ahead: 60, silent: "callisto" });
const { at, until, untilGiven, untilRow, row } = tab;
const reveal = async (panel) => {
  await at("panels-menu").click();
  const box = at(`open-${panel}`);
  if (!(await box.isChecked())) await box.check();
  await tab.page.keyboard.press("Escape");
  await at(`title-${panel}`).click();
};

test("a robot's health is told: ticks, messages a second, when it was last heard", async () => {
  await row("io").getByRole("button").first().click();
  const health = await untilGiven(() => {
    const text = document.querySelector("[data-testid=health-io]")?.innerText ?? "";
    return /\d+ messages\/s/.test(text) && text;
  });
  assert.match(health, /last tick \d+ µs of 20 ms, longest lately \d+ µs/);
  assert.match(health, /0 late ticks/);
  assert.match(health, /heard \d+\.\d s ago/);
});

test("a robot that falls silent raises an alarm, which stays until it is seen", async () => {
  const alarm = at("alarms").locator("[data-alarm=silent][data-robot=callisto]");
  await alarm.waitFor();
  assert.match(await at("alarm-count").innerText(), /^⚠ [1-9]\d* alarms?$/);
  await alarm.getByRole("button", { name: /^Seen/ }).click();
  await until(() => document.querySelector("[data-alarm=silent]")?.dataset.seen === "true");
  await tab.page.keyboard.press("a");
  await at("alarm-count").waitFor({ state: "detached" });
});

test("a robot that is decommissioned stands still until it is commissioned, whoever resumes", async () => {
  await row("io").getByRole("button").first().click();
  await at("more-io").click();
  await at("decommission-io").click();
  await untilRow("io", "data-out-of-service", "true");
  await at("timeline").locator("[data-event=decommissioned]").waitFor();
  await at("commission-io").click();
  await untilRow("io", "data-out-of-service", "false");
});

test("a robot is held and resumed alone", async () => {
  await row("ganymede").getByRole("button", { name: "Hold" }).click();
  await untilRow("ganymede", "data-held", "true");
  assert.equal(await row("io").getAttribute("data-held"), "false");
  await row("ganymede").getByRole("button", { name: "Resume" }).click();
  await untilRow("ganymede", "data-held", "false");
});

test("beside the text stands its graph, with the running state lit in both, and what it does otherwise", async () => {
  await row("ganymede").getByRole("button").first().click();
  await at("program-select").selectOption("sit_and_spin.bhdl");
  await at("edit-button").click();
  await at("editor-graph").locator("[data-state=move_at_random]").waitFor();
  await at("editor-graph").locator("[data-current=true]").waitFor();
  await at("program-changes").locator("[data-sort=added]", { hasText: "move_at_random" }).waitFor();
  await until(() => {
    const lit = document.querySelector("[data-testid=editor-graph] [data-current=true]")?.dataset.state;
    const line = document.querySelector("[data-testid=program-editor] .cm-running");
    return lit !== undefined && line !== null && line.nextElementSibling?.textContent.trim() === `name: "${lit}"`;
  });
});

test("the graph follows as one types, without being asked", async () => {
  await at("program-editor").locator(".cm-content").click();
  await tab.page.keyboard.press("Control+Home");
  await tab.page.keyboard.type('state:\n  name: "dance"\nend\n');
  await at("editor-graph").locator("[data-state=dance]").waitFor();
  await at("program-changes").getByText("dance").waitFor();
  await at("editor-close").click();
});

test("of two programs that are chosen one after the other the second is edited, though the first comes last", async () => {
  const first = "**/api/programs/office_cleanup.bhdl";
  let release;
  const held = new Promise((resolve) => (release = resolve));
  await tab.page.route(first, (route) => held.then(() => route.continue()));
  const late = tab.page.waitForResponse(first);
  await at("program-select").selectOption("office_cleanup.bhdl");
  await at("program-select").selectOption("sit_and_spin.bhdl");
  await at("edit-button").click();
  await at("editor-graph").locator("[data-state=move_at_random]").waitFor();
  release();
  await (await late).finished();
  await tab.page.evaluate(() => new Promise(requestAnimationFrame));
  assert.equal(await at("program-select").inputValue(), "sit_and_spin.bhdl");
  await at("editor-graph").locator("[data-state=move_at_random]").waitFor();
  await at("program-editor").getByText("move_at_random").first().waitFor();
  await at("editor-close").click();
});

test("a program is pushed to one robot, each answer stands there, and the one that drifts raises an alarm", async () => {
  await at("program-select").selectOption("sit_and_spin.bhdl");
  await at("push-target").selectOption("io");
  await at("push-button").click();
  await at("program-changes").waitFor();
  await at("push-confirm").click();
  await tab.untilReply("io", ["running", "confirmed"]);
  await at("alarms").locator("[data-alarm=drift][data-robot=io]").waitFor();
  await tab.page.keyboard.press("a");
  await until(() => document.querySelector("[data-alarm=drift]")?.dataset.seen === "true");
});

test("the push is in the history, and is restored from there with one confirming click", async () => {
  const pushed = at("push-history").locator("li").first();
  await pushed.waitFor();
  const hash = await pushed.getAttribute("data-hash");
  await pushed.getByRole("button", { name: "Restore…" }).click();
  await at("push-confirm").click();
  await untilRow("ganymede", "data-hash", hash);
  await at("push-history").locator("li").nth(1).waitFor();
});

test("the referee's sheet: clock, points and penalties, each robot, each call, and strategies compared", async () => {
  await reveal("referee");
  const clock = await at("referee-clock").innerText();
  await until((before) => document.querySelector("[data-testid=referee-clock]").innerText !== before, clock);
  const { deposited, collisions } = await at("referee").evaluate((panel) => {
    const cell = (robot, i) => Number(panel.querySelectorAll(`[data-testid=score-${robot}] td`)[i].innerText);
    const sum = (i) => ["io", "ganymede", "callisto"].reduce((all, robot) => all + cell(robot, i), 0);
    return { deposited: sum(0), collisions: sum(1) };
  });
  assert.equal(collisions, 2);
  assert.match(await at("referee-penalties").innerText(), /−2 for 2 collisions/);
  assert.ok(deposited >= 1);
  await at("referee").locator("[data-call=deposited]").first().waitFor();
  await at("strategies").locator("[data-strategy='sit_and_spin.bhdl']").waitFor();
});

test("every panel says what it shows, and ? lists panels and keys", async () => {
  for (const panel of ["referee", "timeline", "team"]) {
    await at(`arrange-${panel}`).click();
    assert.ok((await at(`about-${panel}`).innerText()).length > 40);
    await tab.page.keyboard.press("Escape");
  }
  await tab.page.keyboard.press("?");
  await at("help").getByText("What the chosen robot knows").waitFor();
  await at("help").getByText("all alarms are seen").waitFor();
  await tab.page.keyboard.press("Escape");
  await at("help").waitFor({ state: "detached" });
});

test("without a robot, each panel says what to do next", async () => {
  const nobody = await startFixture({ empty: true });
  const page = await tab.browser.newPage({ viewport: tab.page.viewportSize() });
  await page.goto(nobody.url);
  for (const [panel, words] of Object.entries({
    Team: "Start one: galilean robot --name io --bhdl FILE.",
    "State machine": "Start a robot, or wait for one.",
    Why: "Start a robot in the Team panel",
    Timeline: "Start a robot to see it.",
    Variables: "start one to see them.",
  }))
    await page.getByRole("region", { name: panel, exact: true }).locator(".empty", { hasText: words }).first().waitFor();
  await page.close();
  await nobody.stop();
});

tab.testComplaints();
