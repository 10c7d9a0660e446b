// SPDX-License-Identifier: BSD-3-Clause
// How fast the page is, beside what is wanted, on a team that tests/fixture plays (or a live one):
//   node scripts/performance.mjs [--robots 3,30,100] [--seconds 20] [--changes 20] [--minutes 0] [--throttle 1] [--gone 3,20]
//     [--url LIVE] [--chromium PATH]
// --minutes: watch memory for so long with each team; the page remembers ten minutes, so that only from then on it tells
// of a leak. --throttle 6: a phone, of a sixth of this machine's speed. --gone: for how many seconds the monitor is away.
// It takes some two minutes for each team. Needs dist/.
import { readdirSync, readFileSync } from "node:fs";
import { cpus } from "node:os";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";
import { within } from "../../tests/tools/patience.mjs";
import { startFixture } from "../tests/fixture/start.mjs";
import { paint, serveWord } from "./first_paint.mjs";
import { changesToPixels_ms, frames, keysToStops, memory, quantile, throttle, wait_s } from "./measures.mjs";
import { bring, SCREENS } from "./scenes.mjs";

const { values } = parseArgs({
  options: {
    robots: { type: "string", default: "3,30,100" }, seconds: { type: "string", default: "20" }, changes: { type: "string", default: "20" },
    minutes: { type: "string", default: "0" }, throttle: { type: "string", default: "1" }, gone: { type: "string", default: "3,20" },
    url: { type: "string" }, chromium: { type: "string", default: "/usr/bin/chromium" },
  },
});
const ASSETS = new URL("../dist/assets/", import.meta.url);
const PATIENCE_MS = 60_000;
const STOPS = 9;
const rate = Number(values.throttle);
const viewport = rate > 1 ? SCREENS.phone : SCREENS.laptop;
/** By the number of robots. */
const WANTED = {
  frames: { 3: "60", 30: "60", 100: "30" },
  change: { 3: "20 ms, 50 ms", 30: "99 % ≤ 100 ms", 100: "99 % ≤ 250 ms" },
};

const ms = (value) => `${value.toFixed(0)} ms`;
const spread = (all_ms) => `median ${ms(quantile(all_ms, 0.5))}, 99 % ${ms(quantile(all_ms, 0.99))} of ${all_ms.length}`;
const rows = [];
let failed = false;

/** Adds a row of the table: what `measure` tells, or why it could not be measured. */
async function row(what, wanted, measure) {
  const seen = await Promise.resolve().then(measure).catch(({ message }) => ((failed = true), `not measured: ${message.split("\n")[0]}`));
  rows.push([what, wanted, seen]);
  console.error(`${what}: ${seen}`);
}

function sizes() {
  const scripts = readdirSync(ASSETS).filter((name) => name.endsWith(".js"));
  const kB = (names) => (names.reduce((sum, name) => sum + gzipSync(readFileSync(new URL(name, ASSETS))).length, 0) / 1000).toFixed(0);
  const first = scripts.filter((name) => /^(index|page|feed_worker|preload)/.test(name));
  return `${kB(first)} kB at first, ${kB(scripts.filter((name) => !first.includes(name)))} kB when it is needed`;
}

const play = (robots, port) => within(startFixture({ robots, ahead: 60 }, port), () => `a team of ${robots} to be played`, PATIENCE_MS);

async function opened(browser, url) {
  const page = await browser.newPage({ viewport });
  page.setDefaultTimeout(PATIENCE_MS);
  if (rate > 1) await throttle(page, rate);
  await page.goto(url);
  return page;
}

async function measurePaint(browser, url) {
  const word = await serveWord();
  try {
    const measured = paint((address) => opened(browser, address), url, word.url);
    const told = (which) => async () => spread((await measured)[which]);
    await row("first paint", "≤ 300 ms", told("ours_ms"));
    await row("first paint of a page of one word", "", told("word_ms"));
    await row("robots on the map", "", told("robots_ms"));
  } finally {
    word.stop();
  }
}

async function measureTeam(browser, { url, robots, isPlayed }) {
  const page = await opened(browser, url);
  const of = `${robots} ${robots === 1 ? "robot" : "robots"}`;
  await page.locator("[data-testid^=map-robot-]").nth(robots - 1).waitFor();
  await wait_s(3);
  await row(`${of}: frames a second`, WANTED.frames[robots] ?? "", async () => {
    const { gaps_ms, busy } = await frames(page, Number(values.seconds));
    const total_s = gaps_ms.reduce((sum, gap_ms) => sum + gap_ms, 0) / 1000;
    return `${(gaps_ms.length / total_s).toFixed(0)}; 99 % within ${ms(quantile(gaps_ms, 0.99))}; main thread busy ${(busy * 100).toFixed(0)} %`;
  });
  if (isPlayed) {
    const keys = keysToStops(page, { times: STOPS, rate });
    await row(`${of}: key to STOP sent`, "", async () => spread((await keys).keepingUp_ms));
    await row(`${of}: key to STOP sent, while the page catches up`, "", async () => spread((await keys).catchingUp_ms));
  }
  await row(`${of}: change of state to pixel`, WANTED.change[robots] ?? "", async () => {
    if (rate > 1) await bring(page, "why");
    const delays_ms = await changesToPixels_ms(page, Number(values.changes));
    if (delays_ms.length === 0) throw new Error("no change of state came");
    return spread(delays_ms);
  });
  if (Number(values.minutes) > 0) await row(`${of}: memory over ${values.minutes} min`, "", async () => {
    const { samples, more_MB_per_h } = await memory(page, Number(values.minutes));
    const more = more_MB_per_h === undefined ? "" : `; ${more_MB_per_h.toFixed(1)} MB more an hour once its ten minutes are full`;
    return `${samples.map(({ MB }) => MB.toFixed(1)).join(" ")} MB${more}`;
  });
  await page.close();
}

/** How long after the monitor is there again the page is, too. */
async function liveAgain_ms(browser, gone_s) {
  const first = await play(3);
  let second;
  try {
    const page = await opened(browser, first.url);
    await page.locator("[data-testid=connection].live").waitFor();
    await within(first.stop(), () => "the fixture's end", PATIENCE_MS);
    await page.locator("[data-testid=connection].lost").waitFor();
    await wait_s(gone_s);
    second = await play(3, new URL(first.url).port);
    const started_ms = Date.now();
    await page.locator("[data-testid=connection].live").waitFor();
    const took_ms = Date.now() - started_ms;
    await page.close();
    return took_ms;
  } finally {
    await first.stop();
    await second?.stop();
  }
}

async function measurePlayed(browser, robots, withPaint) {
  const team = await play(robots);
  try {
    if (withPaint) await measurePaint(browser, team.url);
    await measureTeam(browser, { url: team.url, robots, isPlayed: true });
  } finally {
    await within(team.stop(), () => "the fixture's end", PATIENCE_MS);
  }
}

function table(browser) {
  console.log(`\nChromium ${browser.version()}, ${cpus().length} cores of ${cpus()[0].model}, ${viewport.width} × ${viewport.height}${rate > 1 ? `, slowed down ${rate} times` : ""}\n`);
  const width = (column) => Math.max(...rows.map((each) => each[column].length));
  const line = (cells) => console.log(`| ${cells.map((cell, i) => cell.padEnd(width(i))).join(" | ")} |`);
  rows.unshift(["what", "wanted", "seen"]);
  line(rows[0]);
  line(rows[0].map((_, i) => "-".repeat(width(i))));
  rows.slice(1).forEach(line);
}

const browser = await chromium.launch({ executablePath: values.chromium, args: ["--no-sandbox", "--disable-gpu"] });
try {
  await row("JavaScript, gzipped", "", sizes);
  if (values.url) {
    await measurePaint(browser, values.url);
    await measureTeam(browser, { url: values.url, robots: 1, isPlayed: false });
  } else {
    const teams = values.robots.split(",").map(Number);
    for (const robots of teams) await measurePlayed(browser, robots, robots === teams[0]);
    for (const gone_s of values.gone.split(",").filter(Boolean).map(Number))
      await row(`live again, after the monitor was gone for ${gone_s} s`, "≤ 1000 ms", async () => ms(await liveAgain_ms(browser, gone_s)));
  }
} catch (error) {
  failed = true;
  console.error(`performance.mjs: ${error.message}`);
} finally {
  table(browser);
  await within(browser.close(), () => "the browser's end", PATIENCE_MS).catch(({ message }) => console.error(`performance.mjs: ${message}`));
}
process.exit(failed ? 1 : 0);
