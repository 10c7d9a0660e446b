// SPDX-License-Identifier: BSD-3-Clause
// STOP ALL says who has stopped and who has not confirmed it, until all have.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 60, deaf: "ganymede", silent: "callisto" });
const { at } = tab;

test("a stop names who has not answered and who drives on", async () => {
  await tab.untilRow("callisto", "data-silent", "true");
  await at("stop-all").click();
  await tab.untilIs("stop-report", "data-stopped", "1");
  await tab.until(() => /1 of 3 stopped; callisto has not answered for \d+.* s, ganymede answers but has not stopped for [1-9]/.test(document.querySelector("[data-testid=stop-report]").textContent));
  assert.equal(await at("stop-report").getByRole("alert").innerText(), "1 stopped, 2 not confirmed");
});

/** Of what is open by that test id: whether it leaves the report in sight, all of it. */
const leavesReport = (open) => tab.until((testid) => {
  const over = document.querySelector(testid)?.getBoundingClientRect();
  const report = document.querySelector("[data-testid=stop-report]").getBoundingClientRect();
  const seen = [report.left + 4, report.right - 4].every((x) => document.elementFromPoint(x, (report.top + report.bottom) / 2)?.closest("[data-testid=stop-report]"));
  return over && over.height > 40 && over.top >= report.bottom && over.bottom <= innerHeight && seen;
}, open);

test("the report stays in sight over the editor, the recordings, the keys and an open menu", async () => {
  await at("edit-button").click();
  await leavesReport("[data-testid=editor]");
  await at("editor-close").click();
  await tab.page.keyboard.press("L");
  await leavesReport("[data-testid=recordings]");
  await at("recordings-close").click();
  await tab.page.keyboard.press("?");
  await leavesReport("[data-testid=help]");
  await tab.page.keyboard.press("Escape");
  await at("panels-menu").click();
  await leavesReport(":popover-open");
  await tab.page.keyboard.press("Escape");
});

test("once the robots are let go nothing is said of the stop", async () => {
  await at("resume-all").click();
  await tab.page.getByRole("button", { name: "Let 1 robot move" }).click();
  await at("stop-report").waitFor({ state: "detached" });
});

tab.testComplaints();
