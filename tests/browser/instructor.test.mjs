// SPDX-License-Identifier: BSD-3-Clause
// The instructor's panel, on a team that is played in a simulation: what it orders, and what it answers.
import assert from "node:assert/strict";
import { test } from "node:test";
import { eventually } from "../tools/patience.mjs";
import { playedTab, startFixture, Tab } from "./tab.mjs";

const tab = playedTab({ ahead: 30, simulated: true });
const { at } = tab;
const answer = (words, done = true) => at("instructor-answers").locator("li").first().and(tab.page.locator(`[data-done="${done}"]`)).filter({ hasText: words }).waitFor();
const place = (name) => at(`movable-${name}`).evaluate(({ dataset }) => [Number(dataset.x), Number(dataset.y)]);
const untilAt = (name, place_m, within_m) => tab.until(([id, [x_m, y_m], most_m]) => {
  const { x, y } = document.querySelector(`[data-testid=movable-${id}]`)?.dataset ?? {};
  return Math.abs(x - x_m) < most_m && Math.abs(y - y_m) < most_m;
}, [name, place_m, within_m]);

test("it is opened by its key, and stands in no arrangement before", async () => {
  await at("map-robot-io").waitFor();
  await tab.until(() => !document.querySelector("[data-testid=title-instructor]"));
  await at("panels-menu").click();
  await at("open-instructor").waitFor();
  await tab.page.keyboard.press("Escape");
  await tab.page.keyboard.press("i");
  await at("instructor").waitFor();
});

test("a key of the panel behind it brings that one into sight, and does there what it does", async () => {
  await tab.page.keyboard.press("?");
  await at("help").getByText("list of break points").waitFor();
  await tab.page.keyboard.press("Escape");
  await tab.page.keyboard.press("B");
  await at("machine").waitFor();
  await at("break-list").waitFor();
  await tab.page.keyboard.press("B");
  await at("break-list").waitFor({ state: "detached" });
  await tab.page.keyboard.press("i");
  await at("instructor").waitFor();
});

test("simulated time stands still and goes on at its word, and the timeline keeps who said so", async () => {
  await at("instructor-pause").click();
  await answer("paused the simulation");
  await at("instructor-clock").filter({ hasText: "paused" }).waitFor();
  await at("instructor-go-on").click();
  await answer("let the simulation go on");
  await at("instructor-rate").selectOption("5");
  await answer("set the rate to 5");
  await tab.until(() => document.querySelector("[data-testid=timeline-instructor] [data-mark=pause] title")?.textContent === "operator paused the simulation");
});

test("the contest pauses and begins anew", async () => {
  await at("contest-pause").click();
  await answer("paused the contest");
  await at("contest-reset").click();
  await at("instructor-contest").filter({ hasText: "waiting" }).waitFor();
  await at("contest-start").click();
  await answer("started the contest");
});

test("a part breaks and is mended", async () => {
  await at("instructor-robot").selectOption("ganymede");
  await at("instructor-part").selectOption("bumper_0");
  await at("instructor-fault").selectOption("stuck");
  await at("instructor-break").click();
  await answer("broke bumper_0 of ganymede: it is stuck");
  await at("mend-ganymede-bumper_0").click();
  await answer("mended bumper_0 of ganymede");
  await tab.until(() => !document.querySelector("[data-testid=mend-ganymede-bumper_0]"));
});

test("a robot is pushed, a piece dropped and removed", async () => {
  await at("instructor-push").click();
  await answer("pushed ganymede with 5 Ns");
  await at("instructor-kind").selectOption("cup");
  await at("instructor-drop").click();
  await answer("dropped cup_901 at (1.00, 1.00) m");
  await at("instructor").getByLabel("Piece to remove").selectOption("cup_901");
  await at("instructor-remove").click();
  await answer("removed cup_901");
});

test("the truth stands beside the belief, with the distance", async () => {
  // Nothing moves: belief and truth are told at different times.
  await at("instructor-pause").click();
  await answer("paused the simulation");
  await at("instructor-truth").check();
  await tab.untilIs("truth-ganymede", "data-far-cm", "19");
  assert.match(await at("truth-ganymede").textContent(), /19 cm/);
});

test("a chair is dragged, and an arrow key moves it by 10 cm", async () => {
  await at("instructor-move").click();
  const from = await place("chair_1");
  const { x, y, width, height } = await at("movable-chair_1").boundingBox();
  const floor = await tab.page.locator("[data-testid=map] .floor").getAttribute("data-px-per-m");
  await tab.page.mouse.move(x + width / 2, y + height / 2);
  await tab.page.mouse.down();
  await tab.page.mouse.move(x + width / 2 - Number(floor) / 2, y + height / 2, { steps: 4 });
  await tab.page.mouse.up();
  await answer("moved chair_1");
  await untilAt("chair_1", [from[0] - 0.5, from[1]], 0.02);
  assert.equal(await tab.page.locator("[data-testid=map] .floor").getAttribute("data-px-per-m"), floor);
  const [x_m, y_m] = await place("chair_1");
  await at("movable-chair_1").focus();
  await tab.page.keyboard.press("ArrowUp");
  await untilAt("chair_1", [x_m, y_m + 0.1], 0.001);
});

test("what cannot be done is answered with the reason", async () => {
  await at("movable-basket_1").focus();
  // From 0.6 m to 0.1 m, however many of the steps are under way at once: only the last place is refused.
  for (let i = 0; i < 5; i += 1) await tab.page.keyboard.press("ArrowLeft");
  await answer("basket_1 cannot stand at", false);
  // The browser logs every answer that is a refusal.
  await eventually(() => tab.complaints.length > 0);
  assert.match(tab.complaints.pop(), /409/);
});

test("while the past is shown, orders act now and say so", async () => {
  await tab.page.keyboard.press("Escape");
  await at("timeline").getByRole("group").focus();
  await tab.page.keyboard.press("ArrowLeft");
  await at("instructor-past").filter({ hasText: "act now" }).waitFor();
  assert.equal(await at("instructor-go-on").innerText(), "Go on now");
  await at("instructor-go-on").click();
  await answer("let the simulation go on");
  await tab.page.keyboard.press("l");
});

test("where no simulation runs, there is no such panel to open", async () => {
  const bare = new Tab();
  const fixture = await startFixture({});
  try {
    await bare.open(fixture.url);
    await bare.at("map-robot-io").waitFor();
    await bare.at("panels-menu").click();
    await bare.at("open-gains").waitFor();
    assert.equal(await bare.at("open-instructor").count(), 0);
  } finally {
    await bare.close();
    await fixture.stop();
  }
});

tab.testComplaints();
