// SPDX-License-Identifier: BSD-3-Clause
// Programs on a live team: pushed, refused, put right, tried on one robot and taken back.
import assert from "node:assert/strict";
import { test } from "node:test";
import { liveTab, PATIENCE_MS, ROBOTS } from "./tab.mjs";

const tab = liveTab();
const { api, at, row, until, untilReply, untilRow } = tab;

test("sit and spin is pushed to the team, and its states appear", async () => {
  const { files } = await api("/api/programs/sit_and_spin.bhdl");
  const { machine, hash } = await api("/api/check", { files });
  const running = await row("io").getAttribute("data-hash");
  assert.notEqual(running, hash);

  await at("program-select").selectOption("sit_and_spin.bhdl");
  await at("push-button").click();
  await at("push-confirm").click();
  for (const robot of ROBOTS) await untilReply(robot, ["running", "confirmed"]);
  for (const robot of ROBOTS) await untilRow(robot, "data-hash", hash);
  for (const { name } of machine.states) await at(`state-${name}`).waitFor();
  await at("machine").locator("[data-current=true]").waitFor();
});

test("a broken program shows its errors with their lines and changes nothing", async () => {
  const running = await row("io").getAttribute("data-hash");
  await at("edit-button").click();
  const text = at("program-editor").locator(".cm-content");
  await text.click();
  await tab.page.keyboard.press("Control+Home");
  await tab.page.keyboard.type("nonsense_here:\n");
  await at("check-button").click();
  await at("diagnostics").getByText(/:1:\d+/).first().waitFor();

  await until(() => {
    const button = document.querySelector("[data-testid=push-button]");
    return button?.disabled && button.title.startsWith("The program has errors");
  });
  assert.equal(await row("io").getAttribute("data-hash"), running);
  await at("editor-close").click();
});

test("what was meant is put in with one click", async () => {
  await at("edit-button").click();
  const text = at("program-editor").locator(".cm-content");
  await text.click();
  await tab.page.keyboard.press("Control+Home");
  await tab.page.keyboard.type("motr_schemas:\nend\n");
  const fix = tab.page.getByRole("button", { name: "Change to 'motor_schemas'" });
  const wrong = text.locator(".cm-lintRange-error").first();
  // What is marked anew under a pointer that rests loses its fixes, and shows them when the pointer moves again.
  const isTaken = async () => {
    await wrong.hover({ position: { x: 8, y: 8 } });
    await wrong.hover({ position: { x: 12, y: 8 } });
    return fix.click({ timeout: 5000 }).then(() => true, () => false);
  };
  for (const deadline = Date.now() + PATIENCE_MS; !(await isTaken()); ) assert.ok(Date.now() < deadline, "no fix is shown");
  await text.getByText(/^motor_schemas:$/).first().waitFor();
  await at("editor-close").click();
});

test("a canary runs a program first, each step is shown, and cancelling takes it back", async () => {
  const running = await row("callisto").getAttribute("data-hash");
  await at("program-select").selectOption("office_cleanup.bhdl");
  await at("push-button").click();
  await at("push-canary").selectOption("callisto");
  await at("push-probation").fill("60");
  await at("push-confirm").click();
  await until((id) => document.querySelector(`[data-testid=${id}]`)?.dataset.state === "running", "step-canary");
  await untilReply("callisto", ["running", "confirmed"]);
  await at("push-cancel").first().click();
  await until((id) => document.querySelector(`[data-testid=${id}]`)?.dataset.state === "cancelled", "step-canary");
  await untilRow("callisto", "data-hash", running);
  assert.equal(await row("io").getAttribute("data-hash"), running);
});

tab.testComplaints();
