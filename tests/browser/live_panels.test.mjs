// SPDX-License-Identifier: BSD-3-Clause
// What only a live team can show: why a robot changed its state, what it knew then, the referee's sheet,
// robots taken out of service, and what a program does otherwise in the monitor's own words.
import assert from "node:assert/strict";
import { test } from "node:test";
import { eventually } from "../tools/patience.mjs";
import { liveTab } from "./tab.mjs";

const tab = liveTab();
const { api, at, until, untilRow, row } = tab;

test("a change of state tells each condition that was tested, and the variables of its tick", async () => {
  await row("io").getByRole("button").first().click();
  await at("variables").locator("[data-variable=shaft]").waitFor(); // of changes before it the page knows no values
  const newest = at("why").locator("li.newest");
  const known = await newest.getAttribute("data-testid");
  const id = await tab.untilGiven((before) => {
    const now = document.querySelector("[data-testid=why] li.newest")?.dataset.testid;
    return now !== before && now;
  }, known);
  const change = at(id);
  // What is opened stays in the list, however often the robot goes round the same states from then on.
  await change.locator("button.head").click();
  const cause = await change.locator(".cause").innerText();
  const fired = await change.locator("[data-finding=fired] .code").first().innerText();
  const [, variable, bit, value] = /^(\w+)\[(\d+)\] = ([01])$/.exec(fired);
  assert.ok(cause.startsWith(`${variable}[${bit}] became ${value}`), `${cause} is not ${fired}`);
  await change.getByTestId("why-values").locator(`[data-variable=${variable}]`).waitFor();
  await change.getByTestId("why-values").locator("[data-variable=shaft]").waitFor();
  await change.locator("button.head").click();
});

test("a condition that is about to fire is told before it does", async () => {
  await until(() => {
    const states = [...document.querySelectorAll("[data-testid=machine] [data-state]")].map(({ dataset }) => dataset.state);
    const said = document.querySelector("[data-testid=machine-nearest]")?.innerText ?? "";
    const [, state] = /^(?:near|now) (\w+) (?:fires now: )?(?:in \d+(?:\.\d)? (?:s|min)|fires now|sure \d\.\d\d, (?:lost below|needs) \d.*|\S+ c?m away, fires at \S+ c?m|\w+ is not known)$/.exec(said) ?? [];
    return states.includes(state);
  });
});

test("a robot that is decommissioned stands still whoever resumes, and takes no program that is pushed to all", async () => {
  await row("callisto").getByRole("button").first().click();
  await at("more-callisto").click();
  await at("decommission-callisto").click();
  await untilRow("callisto", "data-out-of-service", "true");
  await tab.page.keyboard.press("ArrowLeft");
  await tab.page.keyboard.press("l");
  const [running, others] = [await row("callisto").getAttribute("data-hash"), await row("io").getAttribute("data-hash")];
  const { files: [main, ...included] } = await api("/api/programs/office_cleanup.bhdl");
  const { hash } = await api("/api/push", { files: [{ ...main, text: `${main.text}\n; of another text\n` }, ...included] });
  assert.notEqual(hash, others);
  await untilRow("io", "data-hash", hash);
  await api("/api/command", { kind: "resume" });
  const callisto = async () => (await api("/api/status")).robots.find(({ name }) => name === "callisto");
  const stood = await callisto();
  const later = await eventually(async () => {
    const now = await callisto();
    return now.tick > stood.tick + 50 && now;
  });
  assert.deepEqual([later.out_of_service, later.program_hash], [true, running]);
  assert.ok(Math.hypot(later.x_m - stood.x_m, later.y_m - stood.y_m) < 0.02, "it drove");
  await at("commission-callisto").click();
  await untilRow("callisto", "data-out-of-service", "false");
});

test("what a program does otherwise is told in the monitor's words before it is pushed", async () => {
  await at("program-select").selectOption("sit_and_spin.bhdl");
  await at("push-button").click();
  await at("program-changes").locator("[data-sort=added]").first().waitFor();
  await tab.page.getByRole("group", { name: "Confirm the push" }).getByRole("button", { name: "Cancel" }).click();
});

test("the editor's graph is that of the text, with the running state lit in both", async () => {
  await at("program-select").selectOption("office_cleanup.bhdl");
  await at("edit-button").click();
  await at("editor-graph").locator("[data-current=true]").waitFor();
  await at("editor-close").click();
});

test("the referee's sheet is shown, with each call, and the running program among the strategies", async () => {
  await at("panels-menu").click();
  await at("open-referee").check();
  await tab.page.keyboard.press("Escape");
  await at("title-referee").click();
  await at("referee").locator("[data-call]").first().waitFor();
  await until(() => /^\d\d:\d\d$/.test(document.querySelector("[data-testid=referee-clock]")?.innerText ?? ""));
  await at("strategies").locator("[data-strategy]").first().waitFor();
  await at("timeline").locator("[data-call]").first().waitFor({ state: "attached" });
});

test("a number of a live robot is plotted", async () => {
  await at("variables").locator("[data-variable=shaft] [data-quantity=heading]").click();
  await at("plot").locator("canvas").waitFor();
  const shown = await at("plot").locator("[data-line]").innerText();
  await until((before) => document.querySelector("[data-testid=plot] [data-line]").innerText !== before, shown);
});

tab.testComplaints();
