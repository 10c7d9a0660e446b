// SPDX-License-Identifier: BSD-3-Clause
// The page for a beamer: legible at ten metres, without anything to press, with what is wrong in large letters.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, describe, test } from "node:test";
import { startFixture, Tab } from "./tab.mjs";

const axe = readFileSync(createRequire(new URL("../../web/package.json", import.meta.url)).resolve("axe-core/axe.min.js"), "utf8");
const RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];
const BEAMERS = [{ width: 1920, height: 1080 }, { width: 1280, height: 720 }];
/** Of the height: what a text must have to be read at ten metres. */
const LEGIBLE = 1 / 30;

/** The wall of a played team, for the tests of a `describe`. */
function wallOf(play, options = { viewport: BEAMERS[0] }) {
  const tab = new Tab();
  before(async () => {
    tab.fixture = await startFixture(play);
    await tab.open(`${tab.fixture.url}/?wall`, options);
    await tab.at("wall").waitFor();
  });
  after(async () => {
    await tab.close();
    await tab.fixture.stop();
  });
  return tab;
}

/** Every text that is drawn, with its size on the screen as a share of the height, enlargement and all. */
function drawnTexts() {
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const texts = [];
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const element = node.parentElement;
    if (!node.data.trim() || element.closest(".unseen, script, style") || !element.getClientRects().length) continue;
    const svg = element instanceof SVGElement ? element : undefined;
    const enlarged = svg ? svg.getScreenCTM().a ** 2 + svg.getScreenCTM().b ** 2 : 1;
    const ground = element.closest(".ground");
    const scale = svg ? Math.sqrt(enlarged) : ground ? new DOMMatrix(getComputedStyle(ground).transform).a : 1;
    texts.push({ text: node.data.trim(), share: (Number.parseFloat(getComputedStyle(element).fontSize) * scale) / innerHeight });
  }
  return texts;
}

async function assertLegible(page) {
  const texts = await page.evaluate(drawnTexts);
  assert.ok(texts.length > 5, JSON.stringify(texts));
  assert.deepEqual(texts.filter(({ share }) => share < LEGIBLE), []);
  return texts.map(({ text }) => text);
}

/** The texts that are cut off, or that stand beyond the screen. */
function cutOff() {
  return [...document.querySelectorAll("main *")].filter((element) => {
    if (element.closest("svg, .ground, .unseen") || !element.textContent.trim()) return false;
    const { right, bottom } = element.getBoundingClientRect();
    return right > innerWidth + 1 || bottom > innerHeight + 1 || element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).display !== "inline";
  }).map(({ outerHTML }) => outerHTML.slice(0, 160));
}

for (const robots of [3, 30]) {
  describe(`with ${robots} robots`, () => {
    const tab = wallOf({ robots, ahead: 60, silent: "callisto" });

    test("every robot's state, the score and the time are there", async () => {
      await tab.at("wall-robot-ganymede").filter({ hasText: "_" }).waitFor();
      const shown = (name) => tab.until(([what, count]) => document.querySelectorAll(what).length === count, [`[data-testid^=${name}-robot-]`, robots]);
      await shown("wall");
      await tab.untilText("wall-clock", /^\d\d:\d\d\s+left$/);
      await tab.untilText("wall-score", /^\d+\s+of 24 deposited$/);
      await shown("map");
    });

    test("a robot that is silent is called so in its place and in large letters", async () => {
      await tab.untilIs("wall-robot-callisto", "data-condition", "silent");
      await tab.untilText("wall-robot-callisto", /silent \d/);
      await tab.page.locator("[data-kind=alarm]").filter({ hasText: "callisto is silent, for" }).waitFor();
    });

    for (const viewport of BEAMERS) {
      test(`all of it is legible on ${viewport.width} × ${viewport.height}, and nothing is cut off`, async () => {
        await tab.page.setViewportSize(viewport);
        await tab.until((height) => innerHeight === height, viewport.height);
        await tab.untilDrawn();
        await assertLegible(tab.page);
        assert.deepEqual(await tab.page.evaluate(cutOff), []);
      });
    }

    for (const colorScheme of ["light", "dark"]) {
      test(`axe finds no violation, ${colorScheme}`, async () => {
        await tab.page.emulateMedia({ colorScheme });
        await tab.page.evaluate(axe);
        const { violations } = await tab.page.evaluate((rules) => window.axe.run({ runOnly: { type: "tag", values: rules } }), RULES);
        assert.deepEqual(violations.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html.slice(0, 120)}`)), []);
      });
    }

    test("nothing can be pressed, and no key says anything to the robots", async () => {
      const pressable = await tab.page.evaluate(() => [...document.querySelectorAll("button, input, select, textarea, a[href], [tabindex], [role=button]")].filter((each) => !each.closest("[inert]")).length);
      assert.equal(pressable, 0);
      for (const key of [".", "Control+.", "h", "r", "t", "?"]) await tab.page.keyboard.press(key);
      await tab.page.keyboard.press("Tab");
      assert.equal(await tab.page.evaluate(() => document.activeElement.tagName), "BODY");
      const { robots: told } = await tab.api("/api/status");
      assert.deepEqual(told.filter(({ held }) => held), []);
      assert.equal(await tab.page.getByRole("dialog").count(), 0);
    });

    tab.testComplaints();
  });
}

describe("with several robots and the referee silent", () => {
  const tab = wallOf({ robots: 30, ahead: 60, silent: "io,callisto,robot7,robot9,robot20,robot21,referee" });

  test("the robots are one line, and the clock stands and says how old it is", async () => {
    await tab.page.locator("[data-kind=alarm]").filter({ hasText: /6 robots silent: (\w+, ){3}\w+ and 2 more\.$/ }).waitFor();
    await tab.at("wall-clock").filter({ hasText: /^\d\d:\d\d left, (\d\.\d|\d\d) s old$/ }).waitFor();
    const clock = async () => (await tab.at("wall-clock").innerText()).slice(0, 5);
    const before = await clock();
    await tab.untilText("wall-clock", /([6-9]\.\d|\d\d) s old$/);
    assert.equal(await clock(), before);
    await assertLegible(tab.page);
    assert.deepEqual(await tab.page.evaluate(cutOff), []);
  });
});

describe("before anything is known", () => {
  const tab = wallOf({ empty: true }, { viewport: BEAMERS[1] });

  test("it says so", async () => {
    await tab.at("wall-robots").filter({ hasText: "No robot has been heard yet." }).waitFor();
    const texts = await tab.page.evaluate(drawnTexts);
    assert.ok(texts.some(({ text }) => text === "no referee is heard") && texts.some(({ text }) => text === "No map yet."), JSON.stringify(texts));
    assert.deepEqual(texts.filter(({ share }) => share < LEGIBLE), []);
    await tab.until(() => !document.querySelector("[data-testid=wall-notices]"));
  });
});

describe("without a monitor", () => {
  const tab = wallOf({});

  test("it says for how long and how far it is behind, and accuses no robot", async () => {
    await tab.at("wall-robot-io").waitFor();
    await tab.fixture.stop();
    await tab.page.locator("[data-kind=connection]").filter({ hasText: /^⚠ Nothing heard for ([3-9]\.\d|\d\d) s: this page is (\d\.\d|\d\d) s behind\.$/ }).waitFor();
    assert.equal(await tab.page.locator("[data-kind=alarm]").count(), 0);
    assert.notEqual(await tab.at("wall-robot-io").getAttribute("data-condition"), "silent");
    await assertLegible(tab.page);
  });

  test("it recovers by itself when the monitor is back", async () => {
    tab.fixture = await startFixture({}, new URL(tab.url).port);
    await tab.until(() => !document.querySelector("[data-testid=wall-notices]"));
    await tab.untilIs("wall-robot-io", "data-condition", "well");
  });
});
