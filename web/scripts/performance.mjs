// SPDX-License-Identifier: BSD-3-Clause
// How fast the page is, on a team that tests/fixture plays (or a live one): first paint, size, frames a second,
// memory, from a change of state to the pixel, and coming back after the monitor was gone.
//   node scripts/performance.mjs [--robots 3,30] [--seconds 20] [--minutes 1] [--url LIVE] [--chromium PATH]
// --minutes: watch memory for so long with each team; the page remembers ten minutes, so that only from then on
// it tells of a leak. 0: not at all. Without it all takes about five minutes. Needs dist/.
import { readdirSync, readFileSync } from "node:fs";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";
import { startFixture } from "../tests/fixture/start.mjs";

const { values } = parseArgs({
  options: {
    robots: { type: "string", default: "3,30" }, seconds: { type: "string", default: "20" }, minutes: { type: "string", default: "1" },
    url: { type: "string" }, chromium: { type: "string", default: "/usr/bin/chromium" },
  },
});
const ASSETS = new URL("../dist/assets/", import.meta.url);
/** The page's history, with a minute to fill. */
const REMEMBERED_MIN = 11;
const LAPTOP = { width: 1366, height: 768 };

const play = (robots, port) => startFixture({ robots, ahead: 60 }, port);

const sorted = (numbers) => [...numbers].sort((a, b) => a - b);
const quantile = (numbers, share) => sorted(numbers)[Math.min(Math.floor(numbers.length * share), numbers.length - 1)];
const wait_s = (duration_s) => new Promise((done) => setTimeout(done, duration_s * 1000));
const say = (what, words) => console.log(`${what.padEnd(34)} ${words}`);

function sizes() {
  const scripts = readdirSync(ASSETS).filter((name) => name.endsWith(".js"));
  const kB = (names) => names.reduce((sum, name) => sum + gzipSync(readFileSync(new URL(name, ASSETS))).length, 0) / 1000;
  const first = scripts.filter((name) => name.startsWith("index"));
  say("JavaScript, gzipped", `${kB(first).toFixed(0)} kB at first, ${kB(scripts.filter((name) => !first.includes(name))).toFixed(0)} kB when it is needed`);
}

async function firstPaint(browser, url) {
  const paints_ms = [];
  const robots_ms = [];
  for (let run = 0; run < 7; run += 1) {
    const context = await browser.newContext({ viewport: LAPTOP });
    const page = await context.newPage();
    await page.goto(url);
    await page.locator("[data-testid^=map-robot-]").first().waitFor();
    robots_ms.push(await page.evaluate(() => performance.now()));
    paints_ms.push(await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0].startTime));
    await context.close();
  }
  say("first paint", `median ${quantile(paints_ms, 0.5).toFixed(0)} ms of ${paints_ms.length}; robots on the map after ${quantile(robots_ms, 0.5).toFixed(0)} ms`);
}

/** What the page needs of its own main thread tells more than the frames, where a machine draws without a GPU. */
async function frames(page, robots, duration_s) {
  const client = await page.context().newCDPSession(page);
  await client.send("Performance.enable");
  const busy_s = async () => (await client.send("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value;
  const before_s = await busy_s();
  const gaps_ms = await page.evaluate(
    (last_ms) =>
      new Promise((done) => {
        const gaps = [];
        let at = performance.now();
        const end = at + last_ms;
        requestAnimationFrame(function step(now) {
          gaps.push(now - at);
          at = now;
          if (now < end) requestAnimationFrame(step);
          else done(gaps);
        });
      }),
    duration_s * 1000,
  );
  const share = ((await busy_s()) - before_s) / duration_s;
  const rate = gaps_ms.length / duration_s;
  say(`frames a second, ${robots} robots`, `${rate.toFixed(0)}; 99 % of frames within ${quantile(gaps_ms, 0.99).toFixed(0)} ms; main thread busy ${(share * 100).toFixed(0)} %`);
}

/** From the stamp of a robot's change of state to the frame that has it, on one machine's clock. */
async function changeToPixel(page, robots) {
  const delays_ms = await page.evaluate(
    () =>
      new Promise((done) => {
        const newest = () => Number(document.querySelector("[data-testid=why] li.newest")?.dataset.stampS);
        const delays = [];
        let known = newest();
        const observer = new MutationObserver(() => {
          const stamp_s = newest();
          if (!(stamp_s > known)) return;
          known = stamp_s;
          const drawn = new MessageChannel();
          drawn.port1.onmessage = () => {
            delays.push(Date.now() - stamp_s * 1000);
            if (delays.length < 20) return;
            observer.disconnect();
            done(delays);
          };
          requestAnimationFrame(() => drawn.port2.postMessage(0));
        });
        observer.observe(document.querySelector("[data-testid=why]"), { subtree: true, childList: true, attributes: true, characterData: true });
        setTimeout(() => (observer.disconnect(), done(delays)), 90_000);
      }),
  );
  if (delays_ms.length === 0) return say(`change of state to pixel, ${robots}`, "no change of state in 90 s");
  say(`change of state to pixel, ${robots}`, `median ${quantile(delays_ms, 0.5).toFixed(0)} ms, 99 % ${quantile(delays_ms, 0.99).toFixed(0)} ms of ${delays_ms.length}`);
}

/** What is still held after a collection of garbage, each minute. */
async function memory(page, robots, minutes) {
  if (minutes === 0) return;
  const client = await page.context().newCDPSession(page);
  const used_MB = async () => {
    await client.send("HeapProfiler.collectGarbage");
    return (await client.send("Runtime.getHeapUsage")).usedSize / 1e6;
  };
  const steps = Math.max(4, Math.round(minutes));
  const samples = [{ minute: 0, MB: await used_MB() }];
  for (let step = 1; step <= steps; step += 1) {
    await wait_s((minutes * 60) / steps);
    samples.push({ minute: (minutes * step) / steps, MB: await used_MB() });
  }
  say(`memory, ${robots} robots, ${minutes} min`, `${samples.map(({ MB }) => MB.toFixed(1)).join(" ")} MB`);
  const full = samples.filter(({ minute }) => minute >= REMEMBERED_MIN);
  if (full.length > 2) say("", `${(slope(full) * 60).toFixed(1)} MB more an hour, from minute ${full[0].minute} on`);
}

/** By least squares, in MB a minute. */
function slope(samples) {
  const mean = (of) => samples.reduce((sum, each) => sum + of(each), 0) / samples.length;
  const [minute, MB] = [mean((each) => each.minute), mean((each) => each.MB)];
  const sum = (of) => samples.reduce((total, each) => total + of(each), 0);
  return sum((each) => (each.minute - minute) * (each.MB - MB)) / sum((each) => (each.minute - minute) ** 2);
}

async function reconnect(browser) {
  const first = await play(3);
  const page = await browser.newPage({ viewport: LAPTOP });
  await page.goto(first.url);
  await page.locator("[data-testid=connection].live").waitFor();
  await first.stop();
  await page.locator("[data-testid=connection].lost").waitFor();
  await wait_s(3);
  const second = await play(3, new URL(first.url).port);
  const started_ms = Date.now();
  await page.locator("[data-testid=connection].live").waitFor();
  say("live again after the monitor is", `${Date.now() - started_ms} ms`);
  await page.close();
  await second.stop();
}

async function measured(browser, url, robots) {
  const page = await browser.newPage({ viewport: LAPTOP });
  await page.goto(url);
  await page.locator("[data-testid^=map-robot-]").nth(robots - 1).waitFor();
  await wait_s(3);
  await frames(page, robots, Number(values.seconds));
  await changeToPixel(page, robots);
  await memory(page, robots, Number(values.minutes));
  await page.close();
}

const browser = await chromium.launch({ executablePath: values.chromium, args: ["--no-sandbox", "--disable-gpu"] });
try {
  sizes();
  if (values.url) {
    await firstPaint(browser, values.url);
    await measured(browser, values.url, 1);
  } else {
    for (const robots of values.robots.split(",").map(Number)) {
      const team = await play(robots);
      if (robots === 3) await firstPaint(browser, team.url);
      await measured(browser, team.url, robots);
      await team.stop();
    }
    await reconnect(browser);
  }
} finally {
  await browser.close();
}
