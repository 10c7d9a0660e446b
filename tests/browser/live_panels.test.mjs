// SPDX-License-Identifier: BSD-3-Clause
// What only a live team can show: why a robot changed its state, what it knew then, the referee's sheet,
// robots taken out of service, and what a program does otherwise in the monitor's own words.
import assert from "node:assert/strict";
import { test } from "node:test";
import { liveTab } from "./tab.mjs";

const tab = liveTab();
const { at, until, untilRow, row } = tab;

test("a change of state tells each condition that was tested, and the variables of its tick", async () => {
  await row("io").getByRole("button").first().click();
  await at("variables").locator("[data-variable=shaft]").waitFor(); // of changes before it the page knows no values
  const newest = at("why").locator("li.newest");
  const known = await newest.getAttribute("data-testid", { timeout: 120_000 });
  await until((before) => {
    const now = document.querySelector("[data-testid=why] li.newest")?.dataset.testid;
    return now && now !== before;
  }, known);
  const change = at(await newest.getAttribute("data-testid"));
  const cause = await change.locator(".cause").innerText();
  await change.locator("button.head").click();
  const fired = await change.locator("[data-finding=fired] .code").first().innerText();
  const [, variable, bit, value] = /^(\w+)\[(\d+)\] = ([01])$/.exec(fired);
  assert.ok(cause.startsWith(`${variable}[${bit}] became ${value}`), `${cause} is not ${fired}`);
  await change.getByTestId("why-values").locator(`[data-variable=${variable}]`).waitFor();
  await change.getByTestId("why-values").locator("[data-variable=shaft]").waitFor();
  await change.locator("button.head").click();
});

test("a condition that is about to fire is told before it does", async () => {
  await until(() => /^near /.test(document.querySelector("[data-testid=machine-nearest]")?.innerText ?? ""));
  assert.match(await at("machine-nearest").innerText(), /in \d|away|sure|not known|No condition/);
});

test("a robot that is decommissioned stands still whoever resumes, and takes no program that is pushed to all", async () => {
  await row("callisto").getByRole("button").first().click();
  await at("more-callisto").click();
  await at("decommission-callisto").click();
  await untilRow("callisto", "data-out-of-service", "true");
  await tab.page.keyboard.press("ArrowLeft");
  await tab.page.keyboard.press("l");
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
