// SPDX-License-Identifier: BSD-3-Clause
// What of a program has happened at all, drawn on its machine and said in a sentence.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 5 }, { viewport: { width: 1920, height: 1080 } });
const { at } = tab;
const sentence = () => at("coverage-sentence").innerText();

test("it is shown when asked for, by click and by key", async () => {
  await at("state-start").waitFor();
  assert.equal(await at("coverage-sentence").count(), 0);
  await at("machine-coverage").click();
  assert.match(await sentence(), /^\d of 10 states, \d of 15 transitions have happened since \d\d:\d\d:\d\d, when this program began\.$/);
  await tab.page.keyboard.press("o");
  assert.equal(await at("coverage-sentence").count(), 0);
  await tab.page.keyboard.press("o");
});

test("what never happened is drawn so and called so, and the rest is counted", async () => {
  const states = await tab.page.locator("[data-testid=machine] [data-state]").evaluateAll((all) => all.map(({ dataset, textContent }) => ({ count: dataset.count, words: textContent.includes("never entered") })));
  assert.equal(states.length, 10);
  for (const { count, words } of states) assert.equal(words, count === "never");
  assert.ok(states.some(({ count }) => Number(count) > 0) && states.some(({ count }) => count === "never"));
  const never = tab.page.locator("[data-testid=machine] [data-arrow='move_to_trash → wander_for_trash']");
  assert.equal(await never.getAttribute("data-count"), "0");
  assert.notEqual(await never.locator(".line").evaluate((line) => getComputedStyle(line).strokeDasharray), "none");
});

test("a condition that never fired is called so", async () => {
  await at("state-move_to_trash").focus();
  await tab.page.keyboard.press("Enter");
  await at("machine-detail").locator("[data-fired]").first().waitFor();
  const fired = await at("machine-detail").locator("[data-fired]").allInnerTexts();
  assert.equal(fired[0], "never fired");
  assert.match(fired[1], /^fired \d+×$|^never fired$/);
  await tab.page.keyboard.press("Enter");
});

test("a program that is pushed starts anew", async () => {
  // The program before it is seen for longer than a step back in time is.
  await tab.until((from_ms) => Date.now() > from_ms + 2000, Date.now());
  await at("program-select").selectOption("sit_and_spin.bhdl");
  await at("push-button").click();
  await at("push-confirm").click();
  // The robot goes on through its states: what counts is how many it was in when the program was new.
  const said = await tab.untilGiven(() => {
    const text = document.querySelector("[data-testid=coverage-sentence]")?.textContent ?? "";
    return / of 11 states,/.test(text) && text;
  });
  assert.match(said, /^[1-4] of 11 states/);
});

test("in the past it is what had happened until then", async () => {
  // What it says once the page has drawn the instant that a key chose.
  const drawn = () => tab.page.evaluate(async () => {
    for (let frames = 0; frames < 2; frames += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
    return document.querySelector("[data-testid=coverage-sentence]")?.textContent ?? "";
  });
  await at("timeline").locator("[role=slider], [tabindex='0']").first().focus();
  let said = "";
  for (let i = 0; i < 40 && !/ of 10 states,/.test(said); i += 1) {
    await tab.page.keyboard.press("ArrowLeft");
    said = await drawn();
  }
  assert.match(said, / of 10 states,/);
  await tab.until(() => document.querySelectorAll("[data-testid=machine] [data-state]").length === 10);
});

tab.testComplaints();
