// SPDX-License-Identifier: BSD-3-Clause
// A live team: who is in it, where, what each does and why; and stopping it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { liveTab, ROBOTS } from "./tab.mjs";

const tab = liveTab();
const { at, row, until, untilRow } = tab;

test("three robots are in the team and move on the map", async () => {
  for (const robot of ROBOTS) await row(robot).waitFor();
  for (const robot of ROBOTS) await at(`map-robot-${robot}`).waitFor();
  await tab.page.evaluate((robots) => {
    window.begun = Object.fromEntries(robots.map((name) => [name, { ...document.querySelector(`[data-testid=map-robot-${name}]`).dataset }]));
  }, ROBOTS);
  await until((robots) =>
    robots.every((name) => {
      const { x, y } = document.querySelector(`[data-testid=map-robot-${name}]`).dataset;
      return Math.hypot(x - window.begun[name].x, y - window.begun[name].y) > 0.1;
    }), ROBOTS);
});

test("a robot's change of state is lit in its machine, with its cause", async () => {
  await row("io").getByRole("button").first().click();
  const lit = at("machine").locator("[data-testid^=state-][data-current=true]");
  const before = await lit.getAttribute("data-testid");
  await until((id) => {
    const now = document.querySelector("[data-testid=machine] [data-current=true]")?.dataset.testid;
    return now !== undefined && now !== id;
  }, before);
  await at("why").locator("li.newest .cause").waitFor();
});

test("changes of state reach the page", async (t) => {
  await tab.page.evaluate(() => {
    window.delays_ms = [];
    const newest = () => Number(document.querySelector("[data-testid=why] li.newest")?.dataset.stampS);
    let known = newest();
    new MutationObserver(() => {
      if (newest() === known) return;
      known = newest();
      window.delays_ms.push(Date.now() - known * 1000);
    }).observe(document.querySelector("[data-testid=why]"), { subtree: true, childList: true, attributes: true });
  });
  await until(() => window.delays_ms.length >= 5);
  const delays_ms = (await tab.page.evaluate(() => window.delays_ms)).sort((a, b) => a - b);
  t.diagnostic(`from a robot's change of state to the changed page: median ${delays_ms[2].toFixed(0)} ms of 5`);
});

test("score and clock are shown, and the clock runs", async () => {
  const shown = await at("clock").textContent();
  assert.match(shown, /\d\d:\d\d/);
  await until((text) => document.querySelector("[data-testid=clock]").textContent !== text, shown);
  assert.match(await at("score").textContent(), /\d+ of \d+/);
});

test("a variable's certainty decays between its samples", async () => {
  await tab.page.evaluate(() => {
    window.certainties = new Map();
  });
  await until(() =>
    [...document.querySelectorAll("[data-testid=variables] [data-certainty]")].some(({ dataset }) => {
      const before = window.certainties.get(dataset.variable) ?? -1;
      window.certainties.set(dataset.variable, Number(dataset.certainty));
      return Number(dataset.certainty) > 0 && Number(dataset.certainty) < before;
    }), undefined);
});

test("STOP ALL holds every robot, and resuming asks", async () => {
  await at("stop-all").click();
  for (const robot of ROBOTS) await untilRow(robot, "data-held", "true");
  await at("resume-all").click();
  await tab.page.getByRole("button", { name: /^Let .* move$/ }).click();
  for (const robot of ROBOTS) await untilRow(robot, "data-held", "false");
});

tab.testComplaints();
