// SPDX-License-Identifier: BSD-3-Clause
// How fast the page is, beside what is wanted, on a team that tests/fixture plays (or a live one):
//   node scripts/performance.mjs [--robots 3,30,100] [--seconds 20] [--changes 20] [--minutes 0] [--throttle 1] [--gone 3,20]
//     [--url LIVE] [--chromium PATH]
// --minutes: watch memory for so long with each team; the page remembers ten minutes, so that only from then on it tells
// of a leak. --throttle 6: a phone, of a sixth of this machine's speed. --gone: for how many seconds the monitor is away.
// --robots "": no team, only how soon the page is live again. It takes some two minutes for each team, and longer where the
// machine is busy. A signal ends it: what was measured until then is told. Exit codes: 0, 1: something could not be measured,
// 128 + the signal. Needs dist/.
import { readdirSync, readFileSync } from "node:fs";
import { constants, cpus } from "node:os";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";
import { within } from "../../tests/tools/patience.mjs";
import { startFixture } from "../tests/fixture/start.mjs";
import { paint, serveWord } from "./first_paint.mjs";
import { connection, throttle, wait_s } from "./measures.mjs";
import { addPageRows } from "./page_rows.mjs";
import { Rows } from "./rows.mjs";
import { SCREENS } from "./scenes.mjs";
import { ms, spread } from "./words.mjs";

const { values } = parseArgs({
  options: {
    robots: { type: "string", default: "3,30,100" }, seconds: { type: "string", default: "20" }, changes: { type: "string", default: "20" },
    minutes: { type: "string", default: "0" }, throttle: { type: "string", default: "1" }, gone: { type: "string", default: "3,20" },
    url: { type: "string" }, chromium: { type: "string", default: "/usr/bin/chromium" },
  },
});
const ASSETS = new URL("../dist/assets/", import.meta.url);
const PATIENCE_MS = 60_000;
const rate = Number(values.throttle);
const viewport = rate > 1 ? SCREENS.phone : SCREENS.laptop;
const numbers = (option) => values[option].split(",").filter(Boolean).map(Number);
const rows = new Rows();

let browser;
/** Another one where it has ended. Signals end this script, and not the browser below it. */
async function openBrowser() {
  if (browser?.isConnected()) return browser;
  browser = await chromium.launch({ executablePath: values.chromium, args: ["--no-sandbox", "--disable-gpu"], handleSIGINT: false, handleSIGTERM: false, handleSIGHUP: false });
  return browser;
}

function sizes() {
  const scripts = readdirSync(ASSETS).filter((name) => name.endsWith(".js"));
  const kB = (names) => (names.reduce((sum, name) => sum + gzipSync(readFileSync(new URL(name, ASSETS))).length, 0) / 1000).toFixed(0);
  const first = scripts.filter((name) => /^(index|page|feed_worker|preload)/.test(name));
  return `${kB(first)} kB at first, ${kB(scripts.filter((name) => !first.includes(name)))} kB when it is needed`;
}

const play = (robots, port) => within(startFixture({ robots, ahead: 60 }, port), () => `a team of ${robots} to be played`, PATIENCE_MS);

async function opened(url) {
  const page = await (await openBrowser()).newPage({ viewport });
  page.setDefaultTimeout(PATIENCE_MS);
  if (rate > 1) await throttle(page, rate);
  await page.goto(url);
  return page;
}

async function measurePaint(url) {
  const word = await serveWord();
  try {
    const measured = paint(opened, url, word.url);
    const told = (which) => async () => spread((await measured)[which]);
    await rows.add("first paint", "≤ 300 ms", told("ours_ms"));
    await rows.add("first paint of a page of one word", "", told("word_ms"));
    await rows.add("robots on the map", "", told("robots_ms"));
  } finally {
    word.stop();
  }
}

/** How many robots are on the map, once all are that are expected; of a live team nobody knows how many that are. */
async function robotsOn(page, expected = 1) {
  const robots = page.locator("[data-testid^=map-robot-]");
  await within(robots.nth(expected - 1).waitFor({ timeout: 0 }), () => `${expected} robots on the map`, PATIENCE_MS);
  await wait_s(3);
  return robots.count();
}

async function measureTeam(url, expected) {
  const page = await opened(url);
  try {
    const robots = await robotsOn(page, expected);
    await addPageRows(rows, page, { ...values, robots, rate, isPlayed: expected !== undefined });
  } finally {
    await page.close();
  }
}

/** How long after the monitor is there again the page is, too. */
async function liveAgain_ms(gone_s) {
  const first = await play(3);
  let page, second;
  try {
    page = await opened(first.url);
    await connection(page, "live");
    await within(first.stop(), () => "the fixture's end", PATIENCE_MS);
    await connection(page, "lost");
    await wait_s(gone_s);
    second = await play(3, new URL(first.url).port);
    const started_ms = Date.now();
    await connection(page, "live");
    return Date.now() - started_ms;
  } finally {
    await page?.close();
    await first.stop();
    await second?.stop();
  }
}

async function measurePlayed(robots, withPaint) {
  const team = await play(robots);
  try {
    if (withPaint) await measurePaint(team.url);
    await measureTeam(team.url, robots);
  } finally {
    await within(team.stop(), () => "the fixture's end", PATIENCE_MS);
  }
}

async function measureAll() {
  await rows.add("JavaScript, gzipped", "", sizes);
  if (values.url) {
    await measurePaint(values.url);
    return measureTeam(values.url);
  }
  const teams = numbers("robots");
  // A team that cannot be shown leaves the others to be measured.
  for (const robots of teams) await measurePlayed(robots, robots === teams[0]).catch(({ message }) => rows.add(`${robots} robots`, "", () => Promise.reject(new Error(message))));
  for (const gone_s of numbers("gone"))
    await rows.add(`live again, after the monitor was gone for ${gone_s} s`, "≤ 1000 ms", async () => ms(await liveAgain_ms(gone_s)));
}

/** Rejects with the signal's name. */
const signalled = new Promise((_, reject) => {
  for (const signal of ["SIGINT", "SIGTERM", "SIGHUP"]) process.once(signal, () => reject(Object.assign(new Error(`${signal} ended performance.mjs`), { signal })));
});

let code = 0;
try {
  await Promise.race([measureAll(), signalled]);
} catch ({ message, signal }) {
  code = signal ? 128 + constants.signals[signal] : 1;
  rows.end(message);
  console.error(`performance.mjs: ${message}`);
}
const slowed = rate > 1 ? `, slowed down ${rate} times` : "";
rows.print(`Chromium ${browser?.version() ?? "that did not start"}, ${cpus().length} cores of ${cpus()[0].model}, ${viewport.width} × ${viewport.height}${slowed}`);
await within(Promise.resolve(browser?.close()), () => "the browser's end", PATIENCE_MS).catch(({ message }) => console.error(`performance.mjs: ${message}`));
process.exit(code || (rows.failed ? 1 : 0));
