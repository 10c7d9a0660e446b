// SPDX-License-Identifier: BSD-3-Clause
// The page for a beamer: legible at ten metres, without anything to press, with what is wrong in large letters.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { loadAxe, violations } from "./axe.mjs";
import { startFixture, Tab } from "./tab.mjs";

const BEAMERS = [{ width: 1920, height: 1080 }, { width: 1280, height: 720 }];
/** Of the height: what a text must have to be read at ten metres. */
const LEGIBLE = 1 / 30;

/** The wall of a played team, or of a recording that `path` names, for the tests of a `describe`. */
function wallOf(play, options = { viewport: BEAMERS[0] }, path = "/?wall") {
  const tab = new Tab();
  before(async () => {
    tab.fixture = await startFixture(play);
    await tab.open(tab.fixture.url + path, options);
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

/** How many things can be pressed or reached by a key. */
function pressable() {
  return [...document.querySelectorAll("button, input, select, textarea, a[href], [tabindex], [role=button], [role=slider]")].filter((each) => !each.closest("[inert]")).length;
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
      await tab.until(() => document.querySelector("[data-testid=wall-robots] > li").dataset.testid === "wall-robot-callisto");
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
        await loadAxe(tab.page);
        assert.deepEqual(await violations(tab.page), []);
      });
    }

    test("nothing can be pressed, and no key says anything to the robots", async () => {
      assert.equal(await tab.page.evaluate(pressable), 0);
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

describe("while all are held that are heard", () => {
  const tab = wallOf({ robots: 3, ahead: 60, silent: "callisto" });

  test("it says how many are held and who is silent, and never that all are", async () => {
    await tab.untilIs("wall-robot-callisto", "data-condition", "silent");
    await tab.api("/api/command", { kind: "hold" });
    await tab.page.locator("[data-kind=held]").filter({ hasText: "2 robots are held; callisto is silent." }).waitFor();
    await assertLegible(tab.page);
    assert.deepEqual(await tab.page.evaluate(cutOff), []);
  });
});

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

/** Of the fixture's recording: 40 s of three robots, of which callisto falls silent at 8 s. */
describe("of a recording", () => {
  const tab = wallOf({}, { viewport: BEAMERS[1], timezoneId: "UTC" }, "/?wall&recording=office.mcap&at=20");
  const show = (query) => tab.page.goto(new URL(`/?wall&${query}`, tab.fixture.url).href);
  const notice = (kind, words) => tab.page.locator(`[data-kind=${kind}]`).filter({ hasText: words }).waitFor();
  const instant_ms = () => tab.at("replay").getAttribute("data-at-ms").then(Number);

  test("the header says REPLAY, the file and the instant in the replay's colour, and nothing of the present", async () => {
    await tab.untilText("replay", /REPLAY\s+office\.mcap\s+2024-11-28 12:00:\d\d/);
    const colours = await tab.at("replay").evaluate((replay) => {
      const sample = document.body.appendChild(document.createElement("span"));
      sample.style.color = "var(--replay)";
      const wanted = getComputedStyle(sample).color;
      sample.remove();
      return { wanted, shown: [replay, replay.querySelector("time")].map((each) => getComputedStyle(each).color) };
    });
    assert.deepEqual(colours.shown, [colours.wanted, colours.wanted]);
    assert.doesNotMatch(await tab.page.locator("body").innerText(), /\blive\b|behind|Connecting/i);
  });

  test("map, states and score are as they were, and ages go by the recording's time", async () => {
    await tab.at("wall-robot-ganymede").filter({ hasText: "_" }).waitFor();
    await tab.until(() => ["wall", "map"].every((what) => document.querySelectorAll(`[data-testid^=${what}-robot-]`).length === 3));
    await tab.untilText("wall-clock", /^\d\d:\d\d\s+left$/);
    await tab.untilText("wall-score", /^\d+\s+of 24 deposited$/);
    await tab.untilIs("wall-robot-callisto", "data-condition", "silent");
    await tab.untilText("wall-robot-callisto", /silent [1-3]\d s/);
    await notice("alarm", "callisto is silent, for");
  });

  test("all of it is legible, nothing is cut off, and axe finds no violation", async () => {
    await tab.untilDrawn();
    const texts = await assertLegible(tab.page);
    assert.ok(texts.includes("REPLAY") && texts.includes("office.mcap"), JSON.stringify(texts));
    assert.deepEqual(await tab.page.evaluate(cutOff), []);
    await loadAxe(tab.page);
    assert.deepEqual(await violations(tab.page), []);
  });

  test("nothing can be pressed, and no key stops it", async () => {
    await show("recording=office.mcap&at=5");
    await tab.until(() => document.querySelector("[data-testid=replay] time"));
    assert.equal(await tab.page.evaluate(pressable), 0);
    for (const key of [" ", ",", ".", "Home", "L", "?"]) await tab.page.keyboard.press(key);
    const before_ms = await instant_ms();
    await tab.until((least_ms) => Number(document.querySelector("[data-testid=replay]").dataset.atMs) > least_ms, before_ms + 1000);
    assert.equal(await tab.page.getByRole("dialog").count(), 0);
  });

  test("it stands at its end, and says so", async () => {
    await show("recording=office.mcap&at=38");
    await tab.at("wall-replay-end").waitFor();
    await tab.untilText("replay", /2024-11-28 12:00:40/);
    assert.deepEqual(await tab.page.evaluate(cutOff), []);
  });

  test("of one that is damaged is told what is lost", async () => {
    await show("recording=cut.mcap");
    await notice("recording", "cut.mcap is damaged: nothing is left of 12:00:20 to 12:00:22.");
    await tab.untilText("replay", /cut\.mcap/);
  });

  test("one that is not there is told of, with what to do, and asked for no more", async () => {
    await show("recording=gone.mcap");
    await notice("connection", "There is no recording gone.mcap at this monitor: name another one in the address, or put it into /var/lib/galilean/recordings.");
    await tab.untilText("replay-link", /^not opened$/);
    assert.deepEqual(await tab.page.evaluate(cutOff), []);
  });

  test("the browser has nothing to complain of but what was refused", () => {
    assert.deepEqual(tab.complaints.filter((words) => !/404|gone\.mcap/.test(words)), []);
  });
});
