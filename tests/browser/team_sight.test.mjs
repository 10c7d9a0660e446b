// SPDX-License-Identifier: BSD-3-Clause
// On a laptop of 1366 x 768 three robots, their health, all their alarms and the push's place are in sight without scrolling.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LAPTOP, playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 60, silent: "callisto", ailing: "io", looping: "ganymede" });
const { at, until } = tab;

/** The elements that are not wholly in the window, or are scrolled away or covered at their top or bottom. */
const hidden = (what) => tab.page.locator(what).evaluateAll((all, { width, height }) => {
  const isInSight = (element) => {
    const box = element.getBoundingClientRect();
    const seen = (y) => {
      const top = document.elementFromPoint(box.x + box.width / 2, y);
      return top !== null && (element.contains(top) || top.contains(element));
    };
    return box.x >= 0 && box.y >= 0 && box.right <= width && box.bottom <= height && seen(box.y + 2) && seen(box.bottom - 2);
  };
  return all.filter((element) => !isInSight(element)).map(({ dataset, innerText }) => `${dataset.testid ?? dataset.alarm}: ${innerText}`);
}, LAPTOP);

const PARTS = ["team-row-io", "team-row-ganymede", "team-row-callisto", "program-select", "push-target", "push-button"];

async function allInSight() {
  for (const part of PARTS) await at(part).waitFor();
  assert.deepEqual(await hidden([...PARTS.map((part) => `[data-testid=${part}]`), "[data-testid=alarms] [data-alarm]"].join()), []);
}

test("three robots and three alarms are in sight, and the push's place", async () => {
  await until(() => ["silent", "loop", "problem"].every((kind) => document.querySelector(`[data-alarm=${kind}]`)));
  await allInSight();
  await at("health-io").waitFor();
  assert.deepEqual(await hidden("[data-testid=health-io]"), []);
  assert.match(await at("team-row-ganymede").innerText(), /\d µs/);
});

test("so they are with more alarms, in one line each", async () => {
  const { programs } = await tab.api("/api/programs");
  const { files } = await tab.api(`/api/programs/${programs.find(({ name }) => name === "sit_and_spin.bhdl").name}`);
  await tab.api("/api/push", { files, targets: ["io"] });
  await until(() => document.querySelector("[data-alarm=drift]"));
  await until(() => document.querySelectorAll("[data-alarm]").length >= 4);
  await allInSight();
  assert.match(await at("team-row-ganymede").innerText(), /\d µs/, "health is hidden");
});

test("the silent robot stands first, then those with alarms, and a row of one line still has its buttons", async () => {
  const order = () => [...document.querySelectorAll("[data-testid=team-rows] > li")].map(({ dataset }) => dataset.testid);
  await until(() => document.querySelector("[data-testid=team-rows] > li")?.dataset.testid === "team-row-callisto");
  assert.equal((await tab.page.evaluate(order)).length, 3);
  await tab.row("io").getByRole("button").first().click();
  const hold = tab.row("callisto").getByRole("button", { name: "Hold" });
  await hold.waitFor();
  await at("more-callisto").waitFor();
  const { x, width } = await hold.boundingBox();
  const panel = await tab.page.locator("[data-panel=team]").boundingBox();
  assert.ok(x > panel.x && x + width < panel.x + panel.width, "the button is cut off");
});

tab.testComplaints();
