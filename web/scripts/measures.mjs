// SPDX-License-Identifier: BSD-3-Clause
// What performance.mjs measures of a page. Nothing here waits without an end: each wait names what it waited for.
import { within } from "../../tests/tools/patience.mjs";

/** Longer than any of these takes, on a machine that is busy or throttled. */
const PATIENCE_MS = 60_000;
const LONGEST_CHANGES_MS = 90_000;
/** The page's history, with a minute to fill. */
const REMEMBERED_MIN = 11;
const STARVED = 20;
const STARVED_S = 8;

const sorted = (numbers) => [...numbers].sort((a, b) => a - b);
export const quantile = (numbers, share) => sorted(numbers)[Math.min(Math.floor(numbers.length * share), numbers.length - 1)];
export const wait_s = (duration_s) => new Promise((done) => setTimeout(done, duration_s * 1000));

/** Slows the page down by so much; 1: not at all. */
export async function throttle(page, rate) {
  const client = await page.context().newCDPSession(page);
  await client.send("Emulation.setCPUThrottlingRate", { rate });
}

/** The gaps between frames, in ms, and how much of the time the page's own thread was busy: 0..1. */
export async function frames(page, duration_s) {
  const client = await page.context().newCDPSession(page);
  await client.send("Performance.enable");
  const busy_s = async () => (await client.send("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value;
  const [before_s, began_ms] = [await busy_s(), Date.now()];
  const counted = page.evaluate(
    (last_ms) =>
      new Promise((done) => {
        const gaps_ms = [];
        let at_ms = performance.now();
        const end_ms = at_ms + last_ms;
        requestAnimationFrame(function step(now_ms) {
          gaps_ms.push(now_ms - at_ms);
          at_ms = now_ms;
          if (now_ms < end_ms) requestAnimationFrame(step);
          else done(gaps_ms);
        });
        // A page that is given no frame at all has none to count.
        setTimeout(() => done(gaps_ms), last_ms + 5000);
      }),
    duration_s * 1000,
  );
  const gaps_ms = await within(counted, () => "the page's frames to be counted", duration_s * 1000 + PATIENCE_MS);
  return { gaps_ms, busy: (await busy_s() - before_s) / ((Date.now() - began_ms) / 1000) };
}

/** From the stamp of a robot's change of state to the frame that has it, on one machine's clock, in ms each. */
export function changesToPixels_ms(page, changes) {
  const seen = page.evaluate(
    ([wanted, longest_ms]) =>
      new Promise((done) => {
        const newest = () => Number(document.querySelector("[data-testid=why] li.newest")?.dataset.stampS ?? 0);
        const delays_ms = [];
        let known = newest();
        const observer = new MutationObserver(() => {
          const stamp_s = newest();
          if (stamp_s <= known) return;
          known = stamp_s;
          const drawn = new MessageChannel();
          drawn.port1.onmessage = () => {
            delays_ms.push(Date.now() - stamp_s * 1000);
            if (delays_ms.length < wanted) return;
            observer.disconnect();
            done(delays_ms);
          };
          requestAnimationFrame(() => drawn.port2.postMessage(0));
        });
        observer.observe(document.querySelector("[data-testid=why]"), { subtree: true, childList: true, attributes: true, characterData: true });
        setTimeout(() => (observer.disconnect(), done(delays_ms)), longest_ms);
      }),
    [changes, LONGEST_CHANGES_MS],
  );
  return within(seen, () => "changes of state", LONGEST_CHANGES_MS + PATIENCE_MS);
}

/** In the page: notes how long after a key was pressed an order to the robots leaves. */
function watchOrders() {
  const { fetch } = window;
  let pressed_ms;
  addEventListener("keydown", ({ timeStamp }) => (pressed_ms = timeStamp), { capture: true });
  window.ordered = [];
  window.fetch = (...asked) => {
    if (String(asked[0]).includes("/api/command")) window.ordered.push(performance.now() - pressed_ms);
    return fetch(...asked);
  };
}

/** Ready to press the key: it gives how long after that the order left. The robots go on after it. */
async function stopSent_ms(page) {
  const known = await page.evaluate(() => window.ordered.length);
  return async () => {
    await page.keyboard.press(".");
    const sent = await page.waitForFunction((count) => window.ordered[count], known, { timeout: PATIENCE_MS });
    await page.getByTestId("resume-all").click();
    await page.getByRole("button", { name: /^Let \d+ robots? move/ }).click();
    await page.getByRole("button", { name: /^Let \d+ robots? move/ }).waitFor({ state: "detached" });
    await page.getByTestId("resume-all").waitFor({ state: "detached" });
    return sent.jsonValue();
  };
}

/** From the key to the order that leaves, in ms: of a page that keeps up, and of one that has just been starved. */
export async function keysToStops(page, { times, rate }) {
  await page.evaluate(watchOrders);
  const [keepingUp_ms, catchingUp_ms] = [[], []];
  for (let i = 0; i < times; i += 1) {
    keepingUp_ms.push(await (await stopSent_ms(page))());
    await wait_s(0.1 + 0.037 * i);
  }
  for (let i = 0; i < Math.ceil(times / 3); i += 1) {
    const press = await stopSent_ms(page);
    await throttle(page, STARVED);
    await wait_s(STARVED_S);
    await throttle(page, rate);
    catchingUp_ms.push(await press());
  }
  return { keepingUp_ms, catchingUp_ms };
}

/** What is still held after a collection of garbage: so many minutes after the first, in MB. */
export async function memory(page, minutes) {
  const client = await page.context().newCDPSession(page);
  const used_MB = async () => {
    await within(client.send("HeapProfiler.collectGarbage"), () => "the page's garbage to be collected", PATIENCE_MS);
    return (await client.send("Runtime.getHeapUsage")).usedSize / 1e6;
  };
  const steps = Math.max(4, Math.round(minutes));
  const samples = [{ minute: 0, MB: await used_MB() }];
  for (let step = 1; step <= steps; step += 1) {
    await wait_s((minutes * 60) / steps);
    samples.push({ minute: (minutes * step) / steps, MB: await used_MB() });
  }
  const full = samples.filter(({ minute }) => minute >= REMEMBERED_MIN);
  return { samples, more_MB_per_h: full.length > 2 ? slope(full) * 60 : undefined };
}

/** By least squares, in MB a minute. */
function slope(samples) {
  const mean = (of) => samples.reduce((sum, each) => sum + of(each), 0) / samples.length;
  const [minute, MB] = [mean((each) => each.minute), mean((each) => each.MB)];
  const sum = (of) => samples.reduce((total, each) => total + of(each), 0);
  return sum((each) => (each.minute - minute) * (each.MB - MB)) / sum((each) => (each.minute - minute) ** 2);
}

/** Waits until the page says so of its connection: "live", "lost", … */
export function connection(page, state) {
  const said = page.locator(`[data-testid=connection].${state}`).waitFor({ timeout: 0 });
  return within(said, () => `the page's connection to be ${state}`, PATIENCE_MS);
}
