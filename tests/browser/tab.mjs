// SPDX-License-Identifier: BSD-3-Clause
// A browser's tab with the page in it, for one file of tests: `liveTab()` shows the running team whose
// link stands in GALILEAN_URL, `playedTab()` a team that web/tests/fixture plays.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { startFixture as startFixtureAlone } from "../../web/tests/fixture/start.mjs";
import { PATIENCE_MS, within } from "../tools/patience.mjs";

const { chromium } = createRequire(new URL("../../web/package.json", import.meta.url))("playwright-core");

export const ROBOTS = ["io", "ganymede", "callisto"];
export const LAPTOP = { width: 1366, height: 768 };
export const PHONE = { width: 390, height: 844 };
export { PATIENCE_MS };

export const launch = () => chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });

export class Tab {
  complaints = [];

  /** With `browser` in a context of its own there: that browser goes on when the tab is closed. */
  async open(url, { viewport = LAPTOP, browser, ...context } = {}) {
    this.url = url;
    /** What lets the link's reader steer. */
    this.token = new URLSearchParams(new URL(url).hash.slice(1)).get("token");
    this.browser = browser ?? (await launch());
    this.end = () => (browser ? this.page?.close() : this.browser.close());
    this.page = await this.browser.newPage({ viewport, ...context });
    this.page.setDefaultTimeout(PATIENCE_MS);
    this.page.on("console", (message) => message.type() === "error" && this.complaints.push(message.text()));
    this.page.on("pageerror", (error) => this.complaints.push(error.message));
    await this.page.goto(url);
  }

  close = () => within(Promise.resolve(this.end?.()), () => "the browser's end");

  at = (testid) => this.page.getByTestId(testid);
  row = (robot) => this.at(`team-row-${robot}`);

  /** Waits until `condition`, which runs in the page, gives true. */
  until = (condition, argument) => this.page.waitForFunction(condition, argument, { timeout: PATIENCE_MS });

  /** Waits as `until()` does. Returns what `condition` gave then: values of one moment, where the page goes on meanwhile. */
  untilGiven = async (condition, argument) => (await this.until(condition, argument)).jsonValue();

  /** Waits until an element's attribute has the value wanted. */
  untilIs = (testid, attribute, value) =>
    this.until(([id, name, wanted]) => document.querySelector(`[data-testid="${id}"]`)?.getAttribute(name) === wanted, [testid, attribute, value]);

  /** Waits until an element's text matches `pattern`. */
  untilText = (testid, { source }) =>
    this.until(([id, pattern]) => new RegExp(pattern).test(document.querySelector(`[data-testid="${id}"]`)?.innerText ?? ""), [testid, source]);

  /** Waits until what has changed its size is drawn as it is then: an observer of sizes hears of it in the next frame. */
  untilDrawn = () => this.page.evaluate(async () => {
    for (let frames = 0; frames < 2; frames += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
  });

  untilRow = (robot, attribute, value) => this.untilIs(`team-row-${robot}`, attribute, value);

  untilReply = (robot, statuses) =>
    this.until(([id, wanted]) => wanted.includes(document.querySelector(`[data-testid=${id}]`)?.dataset.status), [`reply-${robot}`, statuses]);

  api = async (path, body) => {
    const headers = { "content-type": "application/json", ...(this.token && { authorization: `Bearer ${this.token}` }) };
    const request = body && { method: "POST", headers, body: JSON.stringify(body) };
    return (await fetch(new URL(path, this.url), { ...request, signal: AbortSignal.timeout(PATIENCE_MS) })).json();
  };

  /** The last test of a file: what the browser logged as an error is one. */
  testComplaints = () => test("the browser has nothing to complain of", () => assert.deepEqual(this.complaints, []));
}

/** The page of a live team, for the tests of this file. */
export function liveTab(options) {
  const tab = new Tab();
  before(() => {
    assert.ok(process.env.GALILEAN_URL, "set GALILEAN_URL to the operator's link of a running team's monitor");
    return tab.open(process.env.GALILEAN_URL, options);
  });
  after(tab.close);
  return tab;
}

/** A team that is played: `play` are the fixture's options, such as { robots: 30, silent: "callisto" }. */
export async function startFixture(play, port) {
  const { url, stop } = await within(startFixtureAlone(play, port), () => "the fixture to listen");
  return { url, stop: () => within(stop(), () => "the fixture's end") };
}

/** The page of a played team, for the tests of this file. */
export function playedTab(play, options) {
  const tab = new Tab();
  before(async () => {
    tab.fixture = await startFixture(play);
    await tab.open(tab.fixture.url, options);
  });
  after(async () => {
    try {
      await tab.close();
    } finally {
      await tab.fixture?.stop();
    }
  });
  return tab;
}
