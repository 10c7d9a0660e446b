// SPDX-License-Identifier: BSD-3-Clause
// The team at a glance, as it is played: its alarms, each robot's health, and what is no alarm.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 60, looping: "ganymede", probation: 8 });
const { at, untilRow } = tab;

test("a canary that runs the new program first is no alarm", async () => {
  await tab.until(() => document.querySelectorAll("[data-testid^=team-row-][data-hash]").length === 3);
  const hash = await at("team-row-io").getAttribute("data-hash");
  await tab.page.evaluate(() => {
    window.alarms = [];
    new MutationObserver(() => window.alarms.push(...[...document.querySelectorAll("[data-alarm]")].map(({ dataset }) => dataset.alarm)))
      .observe(document.body, { subtree: true, childList: true });
  });
  const { programs } = await tab.api("/api/programs");
  const { files } = await tab.api(`/api/programs/${programs.find(({ name }) => name === "sit_and_spin.bhdl").name}`);
  const pushed = tab.api("/api/push", { files, canary: "io" });
  const others = await tab.untilGiven((before) => {
    const hashOf = (robot) => document.querySelector(`[data-testid=team-row-${robot}]`).dataset.hash;
    return hashOf("io") !== before && hashOf("callisto");
  }, hash);
  assert.equal(others, hash, "the others run what they ran");
  const { hash: pushedHash } = await pushed;
  for (const robot of ["io", "ganymede", "callisto"]) await untilRow(robot, "data-hash", pushedHash);
  assert.deepEqual(await tab.page.evaluate(() => window.alarms.filter((kind) => kind === "drift")), []);
});

test("a robot that goes round the same states is an alarm that says which, and how often", async () => {
  const alarm = at("alarms").locator("[data-alarm=loop][data-robot=ganymede]");
  await alarm.waitFor();
  assert.match(await alarm.innerText(), /ganymede goes round wander_for_trash → move_to_trash → grab_trash → backup1, \d+ times in \d+(\.\d)? (s|min)\s/);
  assert.equal(await at("alarms").locator("[data-alarm=loop]").count(), 1, "a healthy robot is said to loop");
});

test("the Why panel counts its rounds in one line, which opens to each change", async () => {
  await at("team-row-ganymede").getByRole("button").first().click();
  const rounds = at("why-rounds").first();
  await tab.until(() => Number(document.querySelector("[data-testid=why-rounds]")?.dataset.rounds) >= 5);
  assert.match(await rounds.innerText(), /( → \w+){3} × \d+( in| or more for over) \d/);
  const single = at("why").locator("[data-stamp-s]", { hasText: /backup1 → wander_for_trash(?!can)/ });
  assert.equal(await single.count(), 0, "what repeats itself is still listed");
  await rounds.getByRole("button").first().click();
  await tab.until(() => document.querySelectorAll("[data-testid=why-rounds] [data-stamp-s]").length > 12);
  // Four changes are a round. The page counts no more rounds than it keeps changes of.
  const before = await rounds.locator("[data-stamp-s]").first().getAttribute("data-testid");
  await tab.until((then) => {
    const numberOf = (id) => Number(id?.slice("why-".length));
    return numberOf(document.querySelector("[data-testid=why-rounds] [data-stamp-s]")?.dataset.testid) >= numberOf(then) + 4;
  }, before);
  assert.ok((await rounds.locator("[data-stamp-s]").count()) > 12, "a newer round closed them");

  // It stands still, and so does its list, while one of its changes is opened.
  await tab.api("/api/command", { kind: "hold", targets: ["ganymede"] });
  await untilRow("ganymede", "data-held", "true");
  const opened = await rounds.locator("[data-stamp-s]").nth(3).getAttribute("data-testid");
  await at(opened).getByRole("button").first().click();
  await rounds.getByRole("button").first().click();
  await tab.until(() => document.querySelectorAll("[data-testid=why-rounds] [data-stamp-s]").length === 1);
  assert.equal(await at(opened).getByRole("button").first().getAttribute("aria-expanded"), "true", "the opened change closed with its group");
});

tab.testComplaints();
