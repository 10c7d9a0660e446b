// SPDX-License-Identifier: BSD-3-Clause
// Alarms of several robots in a team of thirty: one line for all that fell silent, which opens to each.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 60, robots: 30, silent: "io,callisto,robot7,robot9,robot20", ailing: "ganymede", refusing: true });
const { at, until, untilRow } = tab;
const group = () => at("alarms").locator("[data-alarm-group=silent]").first();

test("those that are silent are one line that counts and names them, other alarms stand alone", async () => {
  await until(() => document.querySelector("[data-alarm-group=silent]")?.dataset.count === "5");
  assert.match(await group().innerText(), /5 robots silent: .*io, .*callisto|5 robots silent: (?=.*io)(?=.*callisto)(?=.*robot20)/);
  await at("alarms").locator("[data-alarm=problem][data-robot=ganymede]").waitFor();
  assert.equal(await at("alarms").locator("[data-alarm=silent]").count(), 0);
});

test("messages that the monitor did not take are an alarm with topic, reason and count", async () => {
  const refused = at("alarms").locator("[data-alarm=refused][data-robot=stranger]");
  await refused.waitFor();
  assert.match(await refused.innerText(), /12 messages on \/stranger\/state were not taken: RobotState\.heading_rad is not a number/);
});

test("it opens to each of them, and one is seen alone", async () => {
  await group().getByRole("button", { name: /^List each/ }).click();
  const callisto = at("alarms").locator("[data-alarm=silent][data-robot=callisto]");
  assert.match(await callisto.innerText(), /callisto is silent, for \d/);
  await callisto.getByRole("button", { name: /^Seen/ }).click();
  await until(() => document.querySelector("[data-alarm-group=silent]")?.dataset.count === "4");
});

test("the rest is seen with one click, and no other alarm with it", async () => {
  await group().getByRole("button", { name: /^Seen: 4 robots silent/ }).click();
  await until(() => {
    const { seen, count } = document.querySelector("[data-alarm-group=silent]")?.dataset ?? {};
    return seen === "true" && count === "5";
  });
  assert.equal(await at("alarms").locator("[data-alarm=problem]").getAttribute("data-seen"), "false");
});

const inGrid = () => at("team-rows").locator("[data-testid^=team-row-]").evaluateAll((cells) => cells.map(({ dataset }) => [dataset.testid.replace("team-row-", ""), dataset.trouble]));

test("thirty robots stand in a grid, silent ones first, then others in trouble, each by name, and keep their places", async () => {
  const before = await inGrid();
  assert.equal(before.length, 30);
  assert.deepEqual(before.slice(0, 6).map(([name]) => name), ["callisto", "io", "robot7", "robot9", "robot20", "ganymede"]);
  assert.deepEqual([...new Set(before.map(([, trouble]) => trouble))], ["true", "false"]);
  assert.deepEqual(before.slice(6, 9).map(([name]) => name), ["robot4", "robot5", "robot6"]);
  const told = await at("clock").textContent();
  await tab.until((text) => document.querySelector("[data-testid=clock]").textContent !== text, told);
  assert.deepEqual(await inGrid(), before);
});

test("the robot that is chosen in the grid has a row of its own, with its health and what can be done", async () => {
  await at("team-row-robot5").getByRole("button").click();
  await at("health-robot5").waitFor();
  await at("team-chosen").getByRole("button", { name: "Hold" }).click();
  await untilRow("robot5", "data-held", "true");
  await at("team-chosen").getByRole("button", { name: "Resume" }).click();
  await untilRow("robot5", "data-held", "false");
});

tab.testComplaints();
