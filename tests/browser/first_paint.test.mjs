// SPDX-License-Identifier: BSD-3-Clause
// What the page paints before any of its scripts has run, and that nothing moves when the page takes its place.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LAPTOP, PHONE, playedTab } from "./tab.mjs";

const tab = playedTab({ empty: true });
const PAPER = { light: "rgb(241, 241, 238)", dark: "rgb(17, 19, 22)" };
/** The page's own scripts, in files with hashed names. */
const SCRIPTS = "**/assets/*.js";

async function opened({ path = "", block = SCRIPTS, ...context }) {
  const page = await tab.browser.newPage({ viewport: LAPTOP, colorScheme: "light", ...context });
  await page.route(block, (route) => route.abort());
  await page.goto(tab.url + path);
  return page;
}

const paper = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
/** Left, top, width and height of each element in the window, in their order from the top left. */
const boxesOf = (page, what) =>
  page.locator(what).evaluateAll((all) =>
    all.map((each) => each.getBoundingClientRect()).filter(({ width }) => width > 0).map(({ x, y, width, height }) => [x, y, width, height].map(Math.round)).sort((a, b) => a[1] - b[1] || a[0] - b[0]));
const wordShown = (page) => page.getByText("starting …").evaluate((word) => word.checkVisibility({ visibilityProperty: true }) && word.getBoundingClientRect().height > 8);

for (const colorScheme of ["light", "dark"]) {
  test(`without any script the header, the panels and that it starts are painted, ${colorScheme}`, async () => {
    const page = await opened({ colorScheme, block: "**/*.js" });
    assert.ok(await wordShown(page));
    assert.ok(await page.locator("#starting b").isVisible());
    assert.equal((await boxesOf(page, "#starting-places div")).length, 8);
    assert.equal(await paper(page), PAPER[colorScheme]);
    await page.waitForFunction(() => performance.getEntriesByName("first-contentful-paint").length === 1);
    await page.close();
  });
}

test("of the page's own files nothing is read before that is painted", async () => {
  const page = await opened({});
  const readOf = () => [...[...document.styleSheets].map(({ href }) => href), ...[...document.querySelectorAll("link[rel=modulepreload]")].map(({ href }) => href)];
  assert.deepEqual((await page.evaluate(readOf)).filter(Boolean), []);
  await page.close();
});

test("it has the colours that the reader chose", async () => {
  const context = await tab.browser.newContext({ viewport: LAPTOP, colorScheme: "light" });
  const page = await context.newPage();
  await page.goto(tab.url);
  await page.getByRole("button", { name: "system" }).click();
  await page.route(SCRIPTS, (route) => route.abort());
  await page.reload();
  assert.ok(await wordShown(page));
  assert.equal(await paper(page), PAPER.dark);
  await context.close();
});

test("a page that stands otherwise shows no panels where they will not be", async () => {
  for (const path of ["/?wall", "/?wall&recording=office.mcap", "/?layout=map"]) {
    const page = await opened({ path });
    assert.ok(await wordShown(page), path);
    const hidden = await page.locator("#starting-places div").first().evaluate((box) => getComputedStyle(box, "::before").visibility);
    assert.equal(hidden, "hidden", path);
    await page.close();
  }
});

/** A phone's one panel has no gap around it. */
const SCREENS = [
  ["a laptop", LAPTOP, "[data-panel]", 0],
  ["a phone", PHONE, "main", 3],
];
const without = (gap_px, [x, y, width, height]) => [x + gap_px, y + gap_px, width - 2 * gap_px, height - 2 * gap_px];

for (const [screen, viewport, panels, gap_px] of SCREENS) {
  test(`on ${screen} the panels come where they were painted`, async () => {
    const starting = await opened({ viewport });
    const page = await tab.browser.newPage({ viewport });
    await page.goto(tab.url);
    await page.getByTestId("map").waitFor();
    assert.equal(await page.locator("#starting").count(), 0);
    const painted = (await boxesOf(starting, "#starting-places div")).map((box) => without(gap_px, box));
    const shown = await boxesOf(page, panels);
    assert.equal(painted.length, shown.length);
    painted.forEach((box, i) => box.forEach((side, j) => assert.ok(Math.abs(side - shown[i][j]) <= 2, `${box} and ${shown[i]}`)));
    const [word, header] = [await starting.locator("#starting b").boundingBox(), await page.locator("h1").boundingBox()];
    assert.ok(Math.abs(word.x - header.x) <= 1 && Math.abs(word.y + word.height / 2 - header.y - header.height / 2) <= 2, JSON.stringify([word, header]));
    await starting.close();
    await page.close();
  });
}

test("a page whose scripts cannot be read says so", async () => {
  const page = await tab.browser.newPage({ viewport: LAPTOP });
  await page.route("**/assets/page-*.js", (route) => route.abort());
  await page.goto(tab.url);
  await page.getByText("The page could not be read. Load it anew.").waitFor();
  await page.close();
});
