// SPDX-License-Identifier: BSD-3-Clause
// On a laptop of 1366 x 768 three robots, their health, all their alarms and the push's place are in sight without scrolling.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LAPTOP, playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 60, silent: "callisto", ailing: "io", looping: "ganymede" });
const { at, until } = tab;

/** Whether all of an element is in the window, and not scrolled away or covered at its top or bottom. */
const isInSight = (locator) => locator.evaluate((element, { width, height }) => {
  const box = element.getBoundingClientRect();
  const seen = (y) => {
    const top = document.elementFromPoint(box.x + box.width / 2, y);
    return top !== null && (element.contains(top) || top.contains(element));
  };
  return box.x >= 0 && box.y >= 0 && box.right <= width && box.bottom <= height && seen(box.y + 2) && seen(box.bottom - 2);
}, LAPTOP);

async function allInSight() {
  for (const robot of ["io", "ganymede", "callisto"]) assert.ok(await isInSight(at(`team-row-${robot}`)), `${robot} is hidden`);
  for (const alarm of await at("alarms").locator("[data-alarm]").all()) assert.ok(await isInSight(alarm), `hidden: ${await alarm.innerText()}`);
  for (const part of ["program-select", "push-target", "push-button"]) assert.ok(await isInSight(at(part)), `${part} is hidden`);
}

test("three robots and three alarms are in sight, and the push's place", async () => {
  await until(() => ["silent", "loop", "problem"].every((kind) => document.querySelector(`[data-alarm=${kind}]`)));
  await allInSight();
  assert.ok(await isInSight(at("health-io")), "the chosen robot's health is hidden");
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

tab.testComplaints();
