// SPDX-License-Identifier: BSD-3-Clause
// The map of a played team: what is drawn of each item, and going about on it by pointer and by keys.
import assert from "node:assert/strict";
import { test } from "node:test";
import { playedTab } from "./tab.mjs";

const tab = playedTab({ ahead: 60 });
const { at, until, untilIs } = tab;

const objects = () => tab.page.locator("[data-testid^=map-object-]");
const shownPart = () => tab.page.locator("[data-testid=map] .ground svg > g").first().getAttribute("transform");

test("objects have their class's shape, their certainty as opacity, and an ellipse for where they may be", async () => {
  await until(() => document.querySelectorAll("[data-testid^=map-object-] .ellipse").length > 5);
  const drawn = await objects().evaluateAll((all) =>
    all.map((each) => ({ name: each.getAttribute("aria-label"), opacity: Number(each.getAttribute("fill-opacity")), certainty: Number(each.dataset.certainty) })));
  for (const { opacity, certainty } of drawn) assert.ok(Math.abs(opacity - (0.12 + 0.88 * certainty)) < 1e-9);
  assert.ok(new Set(drawn.map(({ opacity }) => opacity.toFixed(1))).size > 2, "all look equally sure");
  assert.ok(drawn.some(({ name }) => /^trash \d+, certainty 0\.\d\d, forgotten in \d/.test(name)));
  assert.equal(drawn.filter(({ name }) => name.startsWith("basket")).length, 2);
});

test("no object is drawn twice", async () => {
  const ids = await objects().evaluateAll((all) => all.map(({ dataset }) => dataset.item));
  assert.equal(new Set(ids).size, ids.length);
});

test("the floor and the trails are drawn on it", async () => {
  await until(() => {
    const canvas = document.querySelector("[data-testid=map] canvas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let [floor, coloured] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] === 255) floor += 1;
      if (data[i + 3] > 0 && Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 60) coloured += 1;
    }
    return floor > 10_000 && coloured > 50;
  });
});

test("each robot's field of view and what it sees are drawn, and can be left out", async () => {
  for (const robot of ["io", "ganymede", "callisto"]) await at(`sight-${robot}`).locator(".view").waitFor({ state: "attached" });
  await until(() => document.querySelectorAll("[data-testid^=sight-] .line").length > 0);
  await at("map-layers").click();
  await at("layer-views").uncheck();
  await until(() => document.querySelectorAll("[data-testid^=sight-] .view").length === 0);
  await at("layer-views").check();
  await tab.page.keyboard.press("Escape");
});

test("the chosen robot's forces are drawn, each and their sum; of all robots when asked", async () => {
  const drawn = await tab.untilGiven(() => {
    const forces = document.querySelector("[data-testid=forces-io]");
    return forces?.dataset.count === "4" && [...forces.querySelectorAll("[data-force]")].map(({ dataset }) => [dataset.force, Number(dataset.strength)]);
  });
  const strengths = new Map(drawn);
  assert.ok(Math.abs(strengths.get("avoid_robot") - 0.5) < 0.01 && Math.abs(strengths.get("noise") - 0.4) < 0.01, "a force is not drawn times its gain");
  assert.ok(strengths.has("sum") && !strengths.has("fetch"), "a schema that does not run is drawn");
  assert.equal(await at("forces-callisto").count(), 0);
  await at("map-layers").click();
  await at("forces-of-all").check();
  await untilIs("forces-callisto", "data-count", "4");
  await at("forces-of-chosen").check();
  await tab.page.keyboard.press("Escape");
});

test("an item that is clicked tells all that is known of it", async () => {
  // One that nobody carries away, and that nothing lies over.
  const { testid, name } = await tab.untilGiven(() => {
    for (const object of document.querySelectorAll("[data-testid^=map-object-]")) {
      const [name] = object.getAttribute("aria-label").split(",");
      const { left, top, width, height } = object.getBoundingClientRect();
      const isFree = object.contains(document.elementFromPoint(left + width / 2, top + height / 2));
      if (isFree && !name.startsWith("trash")) return { testid: object.dataset.testid, name };
    }
    return undefined;
  });
  await at(testid).click();
  const detail = at("map-detail");
  for (const fact of ["certainty", "at", "within", "last seen", "distance"]) await detail.getByText(fact, { exact: true }).waitFor();
  await detail.getByText(name, { exact: true }).waitFor();
  await detail.getByRole("button", { name: "Close" }).click();
  await detail.waitFor({ state: "detached" });
});

test("keys go from item to item, and choose one", async () => {
  await at("map-robot-io").focus();
  await tab.page.keyboard.press("ArrowRight");
  const on = () => tab.page.evaluate(() => document.activeElement?.dataset.item);
  let item = await on();
  if (item === "robot io") {
    await tab.page.keyboard.press("ArrowLeft");
    item = await on();
  }
  assert.notEqual(item, "robot io");
  await tab.page.keyboard.press("Enter");
  await at("map-detail").getByText(new RegExp(`(^| )${item.split(" ")[1]}$`)).first().waitFor();
  await tab.page.keyboard.press("Enter");
});

test("each robot has its name beside it, things when asked, and none lies over another", async () => {
  for (const robot of ["io", "ganymede", "callisto"]) await at("map-labels").locator(`[data-label="robot ${robot}"]`).waitFor({ state: "attached" });
  const named = () => at("map-labels").locator("[data-label]").count();
  const few = await named();
  await at("map-layers").click();
  await at("layer-things").check();
  await until((before) => document.querySelectorAll("[data-testid=map-labels] [data-label]").length > before + 3, few);
  const over = await tab.page.evaluate(() => {
    const must = new Set([...document.querySelectorAll("[data-testid=map] [aria-pressed=true][data-item]")].map(({ dataset }) => dataset.item));
    const texts = [...document.querySelectorAll("[data-testid=map-labels] [data-label]")].filter(({ dataset }) => !must.has(dataset.label) && !dataset.label.startsWith("robot"));
    const boxes = texts.map((text) => [text.textContent, text.getBoundingClientRect()]);
    return boxes.flatMap(([a, one], i) => boxes.slice(i + 1).filter(([, other]) => one.left < other.right - 2 && other.left < one.right - 2 && one.top < other.bottom - 4 && other.top < one.bottom - 4).map(([b]) => `${a} over ${b}`));
  });
  assert.deepEqual(over, []);
  await at("layer-things").uncheck();
  await tab.page.keyboard.press("Escape");
});

test("it pans and zooms by pointer, wheel and keys, and fits again", async () => {
  const fitted = await shownPart();
  const floor = await tab.page.locator("[data-testid=map] .floor").boundingBox();
  const place = { x: floor.x + floor.width - 60, y: floor.y + floor.height / 2 };
  await tab.page.mouse.move(place.x, place.y);
  await tab.page.mouse.wheel(0, -400);
  // By the hand: until then the map may fit itself anew.
  await until((before) => !document.querySelector("[data-testid=map-fit]").disabled && document.querySelector("[data-testid=map] .ground svg > g").getAttribute("transform") !== before, fitted);
  const zoomed = await shownPart();
  await tab.page.mouse.down();
  await tab.page.mouse.move(place.x - 80, place.y + 40, { steps: 4 });
  await tab.page.mouse.up();
  assert.notEqual(await shownPart(), zoomed);
  await tab.page.keyboard.press("f");
  await until(() => document.querySelector("[data-testid=map-fit]").disabled);
  await tab.page.keyboard.press("+");
  await until(() => !document.querySelector("[data-testid=map-fit]").disabled);
  await tab.page.keyboard.press("f");
});

test("it follows the chosen robot until a hand pans it", async () => {
  await at("map-robot-callisto").focus();
  await tab.page.keyboard.press("+");
  await at("team-row-callisto").getByRole("button").first().click();
  await at("map-follow").click();
  await until(() => {
    const floor = document.querySelector("[data-testid=map] .floor").getBoundingClientRect();
    const robot = document.querySelector("[data-testid=map-robot-callisto] .ring").getBoundingClientRect();
    return Math.abs(robot.x + robot.width / 2 - floor.x - floor.width / 2) < 12 && Math.abs(robot.y + robot.height / 2 - floor.y - floor.height / 2) < 12;
  });
  const floor = await tab.page.locator("[data-testid=map] .floor").boundingBox();
  await tab.page.mouse.move(floor.x + 20, floor.y + floor.height / 2);
  await tab.page.mouse.down();
  await tab.page.mouse.move(floor.x + 90, floor.y + floor.height / 2, { steps: 4 });
  await tab.page.mouse.up();
  await untilIs("map-follow", "aria-pressed", "false");
  await tab.page.keyboard.press("f");
});

test("it measures between two places", async () => {
  // Nobody drives under the pointer, and a map that a hand has zoomed does not fit itself anew.
  await tab.api("/api/command", { kind: "hold" });
  for (const robot of ["io", "ganymede", "callisto"]) await tab.untilRow(robot, "data-held", "true");
  await tab.page.keyboard.press("+");
  await at("map-measure").click();
  const { x, y, far_px } = await tab.untilGiven(() => {
    const floor = document.querySelector("[data-testid=map] .floor");
    const { left, top, right, bottom } = floor.getBoundingClientRect();
    const far_px = Math.round(2 * Number(floor.dataset.pxPerM));
    const isBare = (x, y) => {
      const hit = document.elementFromPoint(x, y);
      return hit?.closest(".ground") && !hit.closest("[data-item]");
    };
    for (let y = Math.ceil(top) + 40; y < bottom - 40; y += 10)
      for (let x = Math.ceil(left) + 20; x < right - 20 - far_px; x += 10) if (isBare(x, y) && isBare(x + far_px, y)) return { x, y, far_px };
    return undefined;
  });
  await tab.page.mouse.click(x, y);
  await tab.page.mouse.click(x + far_px, y);
  assert.match(await at("map-legend").textContent(), /^\s*(1\.9[89]|2\.0[0-2]) m, −?0°\s*$/);
  await tab.page.keyboard.press("m");
});

tab.testComplaints();
