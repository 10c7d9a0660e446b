// SPDX-License-Identifier: BSD-3-Clause
// A robot that died is told whole: what it told last stays, grey and with its age, and nothing more is claimed of it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 60, silent: "callisto" });
const { at, row } = tab;

test("its values, its picture and its state are grey and old", async () => {
  await row("callisto").getByRole("button").first().click();
  await tab.until(() => Number(document.querySelector("[data-testid=picture-camera]")?.dataset.shown) > 0);
  await tab.untilRow("callisto", "data-silent", "true");
  await tab.until(() => /^([2-9]\.\d|\d+) s old$/.test(document.querySelector("[data-testid=variables-age]")?.textContent ?? ""));
  await tab.until(() => /^\d.* s old$/.test(document.querySelector("[data-testid=picture-camera] [data-testid=rate]")?.textContent ?? ""));
  assert.ok((await at("variables").locator("tbody tr").count()) > 5, "the last values are kept");
});

test("nothing is said to be near to firing, and it is not among those that run the program", async () => {
  assert.equal(await at("machine-nearest").innerText(), "Not known: callisto is silent.");
  assert.equal(await at("program-share").innerText(), "2 of 2 run it");
});

test("of a push it says that it did not answer", async () => {
  await at("program-select").selectOption("sit_and_spin.bhdl");
  await at("push-button").click();
  await at("push-confirm").click();
  await tab.untilReply("callisto", ["no_answer"]);
  assert.match(await at("reply-callisto").innerText(), /callisto did not answer/);
  assert.equal(await at("step-rest").getAttribute("data-state"), "failed");
  await tab.until(() => /failed: callisto has not answered/.test(document.querySelector("[data-testid=push-history]")?.textContent ?? ""));
});

tab.testComplaints();
