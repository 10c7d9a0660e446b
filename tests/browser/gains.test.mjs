// SPDX-License-Identifier: BSD-3-Clause
// A gain that is moved comes to the robots by itself, as a push, and into the draft.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 10, probation: 8 });
const { at } = tab;
const KEY = "combine_forces combine gains noise";
const row = () => tab.page.locator(`[data-gain="${KEY}"]`);
const running = (value) => tab.until(([key, wanted]) => document.querySelector(`[data-gain="${key}"]`)?.dataset.value === wanted, [KEY, value]);
/** Has the page keep each answer of the number as it comes: some stand for less than a second. */
const noteAnswers = () => tab.page.evaluate((key) => {
  window.answers = [];
  const note = () => {
    const words = document.querySelector(`[data-gain="${key}"] [data-answer]`)?.textContent;
    if (words && words !== window.answers.at(-1)) window.answers.push(words);
  };
  new MutationObserver(note).observe(document.body, { subtree: true, childList: true, characterData: true });
}, KEY);
const pushes = async () => (await tab.api("/api/pushes")).pushes;

test("the running program's gains have sliders, where they run", async () => {
  await at("title-gains").click();
  await running("0.4");
  assert.match(await row().innerText(), /gain of noise\s+0\.4\s+runs: 0\.4/);
});

test("a slider that rests is one push to the team, which says what it changes", async () => {
  await noteAnswers();
  await row().getByRole("slider").focus();
  // None of the four waits for the one before: between them the hand would rest.
  await Promise.all(Array.from({ length: 4 }, () => tab.page.keyboard.press("ArrowRight")));
  await running("0.44");
  await row().locator("[data-answer=good]").filter({ hasText: "taken" }).waitFor();
  const told = await tab.page.evaluate(() => window.answers);
  const steps = ["on its way…", "runs, on probation", "taken"];
  assert.deepEqual(told.filter((words) => steps.includes(words)), steps, told.join("; "));
  const [push, ...more] = await pushes();
  assert.deepEqual(more, []);
  assert.match(push.author, /^\S+ \(combine · gain of noise 0\.4 → 0\.44\)$/);
  assert.doesNotMatch(push.author, /^operator /, "it names who moved it");
  const { files } = await tab.api(`/api/pushed/${push.hash}`);
  assert.match(files[0].text, /gains: 1 0\.44 ; how much each counts/);
});

test("the draft has the number", async () => {
  await at("title-program").click();
  await at("edit-button").click();
  await at("program-editor").locator(".cm-content").click();
  await tab.page.keyboard.press("Control+End");
  await at("program-editor").locator(".cm-line").filter({ hasText: "gains: 1 0.44 ; how much each counts" }).waitFor();
  await tab.page.keyboard.press("Escape");
  await at("title-gains").click();
});

test("undo brings the number back", async () => {
  await at("gains-undo").click();
  await running("0.4");
  await tab.until(() => !document.querySelector("[data-testid=gains-undo]"));
  assert.equal((await pushes()).length, 2);
});

test("STOP ALL works by key from a slider", async () => {
  await row().getByRole("slider").focus();
  await tab.page.keyboard.press(".");
  await tab.untilRow("io", "data-held", "true");
});

tab.testComplaints();
