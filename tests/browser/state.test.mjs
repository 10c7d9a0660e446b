// SPDX-License-Identifier: BSD-3-Clause
// Why, state machine, variables, plots and timeline of a played team: what a robot does, and why.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LAPTOP, playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 40 });
const { at, until, untilGiven } = tab;
const row = (variable) => at("variables").locator(`[data-variable="${variable}"]`);
const quantity = (variable, name) => row(variable).locator(`[data-quantity="${name}"]`);
const span_s = () => at("timeline").locator(".rows").evaluate(({ dataset }) => (dataset.toMs - dataset.fromMs) / 1000);
const backToLive = () => tab.page.keyboard.press("l");

test("a change of state is opened: what fired, what did not, and what the robot knew at that tick", async () => {
  await row("shaft").waitFor(); // of changes before it the page knows no values
  const before = await at("why").locator("li.newest").getAttribute("data-testid");
  const id = await untilGiven((known) => {
    const now = document.querySelector("[data-testid=why] li.newest")?.dataset.testid;
    return now !== known && now;
  }, before);
  const change = at(id);
  await change.getByRole("button", { expanded: false }).click();
  assert.equal(await change.locator("[data-finding=fired]").count(), 1);
  await change.getByTestId("why-values").locator("[data-variable=shaft]").waitFor();
  assert.match(await change.locator("[data-finding=fired]").innerText(), /\w+\[\d\] = 1/);
});

test("its line opens the editor there", async () => {
  // Of one change: a newer one may come before its line is clicked.
  const { id, words } = await untilGiven(() => {
    const place = document.querySelector("[data-testid=why] li.newest .cause button");
    return place && { id: place.closest("li").dataset.testid, words: place.innerText };
  });
  const [, file, line] = /^(\S+):(\d+)$/.exec(words);
  const { files } = await tab.api(`/api/programs/${file}`);
  const condition = files[0].text.split("\n").slice(line - 1, Number(line) + 5);
  assert.match(condition[0], /condition:/);
  await at(id).locator(".cause button").click();
  await until((wanted) => {
    let shown = document.querySelector("[data-testid=program-editor] .cm-activeLine");
    return wanted.every((text) => {
      const same = shown?.textContent === text;
      shown = shown?.nextElementSibling;
      return same;
    });
  }, condition);
  await at("editor-close").click();
});

test("an instant of a change is shown everywhere, and one key leads back", async () => {
  await at("why").locator("li[data-testid^=why-]").first().locator("button.head").click();
  const open = at("why").getByRole("button", { name: "Show everything at that instant" }).first();
  if (!(await open.isVisible())) await at("why").locator("button.head").first().click();
  await open.click();
  await at("timeline-cursor").waitFor();
  await at("timeline-live").waitFor();
  await backToLive();
  await at("timeline-cursor").waitFor({ state: "detached" });
});

test("the past is told from the present, and what acts says that it acts now", async () => {
  await at("past-notice").waitFor({ state: "detached" });
  await at("timeline").locator(".rows").focus();
  await tab.page.keyboard.press("ArrowLeft");
  await tab.page.keyboard.press("ArrowLeft");
  assert.match(await at("past-notice").innerText(), /Shown as it was at \d\d:\d\d:\d\d, \d+(\.\d)? s ago\.[^]*The list of alarms, programs, pictures, gains and the map's floor are the present's\. Buttons, sliders and keys that give orders act now\./);
  assert.match(await at("figures-at").innerText(), /^at \d\d:\d\d:\d\d$/);
  assert.equal((await at("push-button").innerText()).trim(), "Push now…");
  await at("past-live").click();
  await at("figures-at").waitFor({ state: "detached" });
  assert.equal((await at("push-button").innerText()).trim(), "Push…");
});

test("the state machine fits its panel, lights the current state, and says how long it lasts", async () => {
  const graph = at("machine").locator("svg[data-scale]");
  assert.ok(Number(await graph.getAttribute("data-scale")) >= 0.85);
  const room = await at("machine").locator(".room").evaluate(({ scrollWidth, clientWidth, scrollHeight, clientHeight }) => scrollWidth <= clientWidth && scrollHeight <= clientHeight);
  assert.ok(room, "it is larger than its room");
  const { lit, told } = await untilGiven(() => {
    const lit = document.querySelector("[data-testid=machine] [data-current=true]")?.dataset.state;
    return lit && { lit, told: document.querySelector("[data-testid=machine-state]").innerText };
  });
  assert.equal(told, lit);
  assert.match(await at("machine-since").innerText(), /^\d+(\.\d)? s$/);
  await until(() => document.querySelector("[data-testid=machine] .arrow.lit"));
});

test("the states keep their places when the panel changes size, until they are placed anew", async () => {
  const places = () => at("machine").locator("g[data-state]").evaluateAll((states) =>
    states.map((state) => [state.dataset.state, ...["x", "y"].map((side) => state.querySelector("rect").getAttribute(side))].join(" ")),
  );
  const width = () => at("machine").locator(".room").evaluate(({ clientWidth }) => clientWidth);
  const before = await places();
  for (const size of [{ width: 1900, height: 460 }, { width: 1100, height: 1000 }]) {
    const before_px = await width();
    await tab.page.setViewportSize(size);
    await until((known) => document.querySelector("[data-testid=machine] .room").clientWidth !== known, before_px);
    await tab.untilDrawn();
    assert.deepEqual(await places(), before);
  }
  await tab.page.setViewportSize({ width: 1900, height: 460 });
  await at("machine-anew").click();
  await at("machine-anew").waitFor({ state: "detached" });
  assert.notDeepEqual(await places(), before);
  await tab.page.setViewportSize(LAPTOP);
});

test("a name that has no room is shortened in its middle, and whole on hover", async () => {
  const doing = at("machine-state");
  await doing.evaluate(({ style }) => (style.width = "40px"));
  // The robot goes on to its next state meanwhile, and the name of that may be so short that it has room.
  const { short, title, whole } = await untilGiven(() => {
    const name = document.querySelector("[data-testid=machine-state] .name.cut");
    const isFitted = name && Number.parseFloat(getComputedStyle(name, "::before").width) <= name.clientWidth + 1;
    return isFitted && { short: name.dataset.short, title: name.title, whole: name.innerText };
  });
  const [, head, tail] = /^(\w+)…(\w+)$/.exec(short) ?? assert.fail(short);
  assert.ok(whole.startsWith(head) && whole.endsWith(tail) && whole.length > short.length, `${short} of ${whole}`);
  assert.equal(title, whole);
  await doing.evaluate((element) => element.removeAttribute("style"));
});

test("a state's conditions show their bits live, by pointer and by keyboard alike", async () => {
  const state = at("state-wander_for_trash");
  await state.hover();
  const detail = at("machine-detail");
  await detail.waitFor();
  assert.equal(await detail.getAttribute("data-of"), "wander_for_trash");
  const gripper = detail.locator("[data-condition='gripper[0]']");
  assert.match(await gripper.getAttribute("data-bit"), /^(0|1|invalid)$/);
  await tab.page.mouse.move(5, 5);
  await detail.waitFor({ state: "detached" });
  await state.focus();
  await detail.waitFor();
  await tab.page.keyboard.press("ArrowDown");
  await until(() => document.querySelector("[data-testid=machine-detail]")?.dataset.of !== "wander_for_trash");
  await tab.page.evaluate(() => document.activeElement.blur());
});

test("variables are filtered by words and by kind", async () => {
  await row("shaft").waitFor();
  await at("variables-filter").fill("locate tra");
  await row("shaft").waitFor({ state: "detached" });
  await row("trash").waitFor();
  await at("variables-filter").fill("");
  await at("variables-kind").selectOption("force");
  await row("trash").waitFor({ state: "detached" });
  await row("noise").waitFor();
  await at("variables-kind").selectOption("all");
  await row("trash").waitFor();
});

test("a number is plotted as it changes, and its certainty beside it", async () => {
  await quantity("noise", "x").click();
  const plot = at("plot").filter({ hasText: "noise x" });
  await plot.locator("canvas").waitFor();
  const shown = () => plot.locator("[data-line]").innerText();
  const before = await shown();
  await until((text) => document.querySelector("[data-testid=plot] [data-line]").innerText !== text, before);
  assert.match(await shown(), /^−?\d+\.\d\d/);
  await quantity("trash", "certainty").click();
  await until(() => document.querySelectorAll("[data-testid=plot]").length === 2);
});

test("the plots' cursor is the timeline's: pointing at one is pointing at the other, a click shows that instant", async () => {
  await at("plot").first().scrollIntoViewIfNeeded();
  const canvas = await at("plot").first().locator(".u-over").boundingBox();
  await tab.page.mouse.move(canvas.x + canvas.width - 4, canvas.y + 20);
  await at("timeline").locator(".pointed").waitFor();
  await tab.page.mouse.click(canvas.x + canvas.width - 14, canvas.y + 20);
  await at("timeline-cursor").waitFor();
  await backToLive();
  await tab.page.mouse.move(5, 5);
});

test("a number is plotted no more when it is clicked again", async () => {
  await quantity("noise", "x").click();
  await quantity("trash", "certainty").click();
  await at("plots").getByText("Nothing is plotted yet").waitFor();
});

test("a force is picked out on the map", async () => {
  await at("force-noise").click();
  await at("forces-io").locator("[data-force=noise][data-lit=true]").waitFor();
  await at("force-noise").click();
  await at("forces-io").locator("[data-lit=true]").waitFor({ state: "detached" });
});

test("the timeline zooms by wheel and by keys about what is pointed at, pans, and leads back to live", async () => {
  const before_s = await span_s();
  const box = await at("timeline").locator(".rows").boundingBox();
  await tab.page.mouse.move(box.x + box.width - 60, box.y + 30);
  await tab.page.mouse.wheel(0, -400);
  await until((before) => {
    const { toMs, fromMs } = document.querySelector("[data-testid=timeline] .rows").dataset;
    return (toMs - fromMs) / 1000 < before / 2;
  }, before_s);
  const zoomed_s = await span_s();
  await at("timeline").locator(".rows").focus();
  await tab.page.keyboard.press("-");
  assert.ok((await span_s()) > zoomed_s * 1.4);
  await tab.page.keyboard.press("PageUp");
  await at("timeline-live").click();
  await at("timeline-live").waitFor({ state: "detached" });
});

test("bars carry their states' names, and the referee's calls and pushes stand among them", async () => {
  await tab.page.keyboard.press("]");
  await at("timeline").locator("g title").first().waitFor({ state: "attached" });
  await at("timeline").locator("[data-call=deposited]").first().waitFor();
  await tab.api("/api/push", { files: (await tab.api("/api/programs/sit_and_spin.bhdl")).files, targets: ["io"], author: "tester" });
  await until(() => [...document.querySelectorAll("[data-testid=timeline] path title, [data-testid=timeline] g title")].some(({ textContent }) => textContent.includes("sit_and_spin")));
});

tab.testComplaints();
