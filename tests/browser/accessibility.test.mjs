// SPDX-License-Identifier: BSD-3-Clause
// WCAG 2.2 AA as far as axe can tell: dark and light, laptop and phone, with everything open that can be opened;
// the page by keys alone; with less motion; and on paper.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { loadAxe, violations } from "./axe.mjs";
import { keysOf } from "./keys.mjs";
import { LAPTOP, PATIENCE_MS, PHONE, playedTab, startFixture } from "./tab.mjs";

const tab = playedTab({ ahead: 60, silent: "callisto", simulated: true });

async function opened({ colorScheme = "light", viewport = LAPTOP, ...rest } = {}) {
  const page = await tab.browser.newPage({ viewport, colorScheme, ...rest });
  page.setDefaultTimeout(PATIENCE_MS);
  await page.goto(tab.url);
  await page.getByTestId("map-robot-io").waitFor();
  await loadAxe(page);
  return page;
}

// Two at a time: each takes as long as axe computes.
describe("what can be opened", { concurrency: 2 }, () => {
  for (const colorScheme of ["light", "dark"]) {
    test(`a laptop's page, ${colorScheme}, has no violation, nor have its menus, its help and its editor`, async () => {
      const page = await opened({ colorScheme });
      await page.locator("[data-testid=picture-camera][data-shown]:not([data-shown='0'])").waitFor();
      assert.deepEqual(await violations(page), []);
      for (const menu of ["panels-menu", "arrange-map", "map-layers"]) {
        await page.getByTestId(menu).click();
        assert.deepEqual(await violations(page), [], menu);
        await page.keyboard.press("Escape");
      }
      await page.getByTestId("map-robot-io").focus();
      await page.keyboard.press("Enter");
      assert.deepEqual(await violations(page), [], "what is known of an item on the map");
      await page.keyboard.press("i");
      await page.getByTestId("instructor-truth").check();
      await page.getByTestId("instructor-break").click();
      await page.getByTestId("instructor-move").click();
      await page.getByTestId("map-moves").filter({ hasText: "it is dead" }).waitFor();
      assert.deepEqual(await violations(page), [], "the instructor's panel, and what can be moved on the map");
      await page.keyboard.press("?");
      assert.deepEqual(await violations(page), [], "keys");
      await page.keyboard.press("Escape");
      await page.getByTestId("edit-button").click();
      await page.getByTestId("program-editor").locator(".cm-content").waitFor();
      assert.deepEqual(await violations(page), [], "editor");
      await page.close();
    });

    test(`a phone's page, ${colorScheme}, has none in any of its panels`, async () => {
      const page = await opened({ colorScheme, viewport: PHONE });
      const tabs = await page.locator("footer [data-testid^=tab-]").evaluateAll((all) => all.map(({ dataset }) => dataset.testid));
      assert.ok(tabs.length >= 8, tabs.join(" "));
      for (const each of tabs) {
        await page.getByTestId(each).click();
        assert.deepEqual(await violations(page), [], each);
      }
      await page.close();
    });
  }
});

test("a page that is behind, and greys what it last heard, has none either", async () => {
  const late = await startFixture({ ahead: 60, late: true });
  const check = async (colorScheme) => {
    const page = await tab.browser.newPage({ viewport: LAPTOP, colorScheme });
    await page.goto(late.url);
    await page.locator("[data-testid=team-rows][data-stale=true] [data-testid=team-row-io]").waitFor({ timeout: PATIENCE_MS });
    await loadAxe(page);
    assert.deepEqual(await violations(page), [], colorScheme);
    await page.close();
  };
  await Promise.all(["light", "dark"].map(check));
  await late.stop();
});

const TABS_AT_ONCE = 20;

/** In the page: notes in which panels the keyboard has been, and what did not show that it had the focus. */
function noteFocus() {
  window.focused = { panels: new Set(), plain: new Set() };
  document.addEventListener("focusin", ({ target }) => {
    const { panels, plain } = window.focused;
    const panel = target.closest("[data-panel]")?.dataset.panel;
    if (panel) panels.add(panel);
    if (!target.closest("svg") && getComputedStyle(target).outlineStyle === "none") plain.add(target.outerHTML.slice(0, 200));
  }, true);
}

test("Tab reaches every panel, its title shows the focus, and STOP ALL works by key from anywhere", async () => {
  const page = await opened();
  const all = await page.locator("[data-panel]").evaluateAll((places) => places.map(({ dataset }) => dataset.panel));
  assert.ok(all.length >= 8, all.join(" "));
  await page.evaluate(noteFocus);
  const press = await keysOf(page);
  const reached = () => page.evaluate(() => [...window.focused.panels].sort());
  // More than once around the page: what is drawn late is reached the second time.
  for (let presses = 0; presses < 120 || (presses < 400 && (await reached()).length < all.length); presses += TABS_AT_ONCE)
    await press(Array(TABS_AT_ONCE).fill("Tab"));
  assert.deepEqual(await page.evaluate(() => [...window.focused.plain]), [], "what has the focus does not show it");
  assert.deepEqual(await reached(), all.sort());
  await page.keyboard.press(".");
  await page.locator("[data-testid=team-row-io][data-held=true]").waitFor();
  await page.close();
});

test("whoever asked for less motion sees none", async () => {
  const page = await opened({ reducedMotion: "reduce" });
  const moving = await page.evaluate(() =>
    [...document.querySelectorAll("*")].filter((each) => {
      const { transitionDuration, animationName } = getComputedStyle(each);
      return animationName !== "none" || transitionDuration.split(",").some((duration) => Number.parseFloat(duration) > 0);
    }).length);
  assert.equal(moving, 0);
  await page.close();
});

test("on paper stand the panels and no buttons, dark ink on white", async () => {
  const page = await opened({ colorScheme: "dark" });
  await page.emulateMedia({ media: "print" });
  const { background, stop, map } = await page.evaluate(() => ({
    background: getComputedStyle(document.body).backgroundColor,
    stop: getComputedStyle(document.querySelector("[data-testid=stop-all]")).visibility,
    map: getComputedStyle(document.querySelector("[data-testid=map]")).visibility,
  }));
  assert.equal(background, "rgb(255, 255, 255)");
  assert.deepEqual([stop, map], ["hidden", "visible"]);
  await page.close();
});

tab.testComplaints();
