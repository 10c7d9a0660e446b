// SPDX-License-Identifier: BSD-3-Clause
// When a page paints first, beside one that paints as soon as any can.
import { createServer } from "node:http";

const PATIENCE_MS = 60_000;
const PAINTS = 7;

/** When something was painted first, in ms from when the page was asked for. */
async function firstPaint_ms(page) {
  const painted = () => performance.getEntriesByName("first-contentful-paint")[0]?.startTime;
  return (await page.waitForFunction(painted, undefined, { timeout: PATIENCE_MS })).jsonValue();
}

/** A page of one word, which paints as soon as any can. */
export async function serveWord() {
  const server = createServer((_, response) => response.writeHead(200, { "content-type": "text/html" }).end("<!doctype html><title>word</title><p>word"));
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  return { url: `http://127.0.0.1:${server.address().port}`, stop: () => (server.closeAllConnections?.(), server.close()) };
}

/** Of the page at `url` beside that of one word, in ms each. They take turns, so that what else the machine does changes both alike. */
export async function paint(open, url, wordUrl) {
  const [ours_ms, word_ms, robots_ms] = [[], [], []];
  for (let run = 0; run < PAINTS; run += 1) {
    const word = await open(wordUrl);
    word_ms.push(await firstPaint_ms(word));
    await word.close();
    const ours = await open(url);
    await ours.locator("[data-testid^=map-robot-]").first().waitFor();
    robots_ms.push(await ours.evaluate(() => performance.now()));
    ours_ms.push(await firstPaint_ms(ours));
    await ours.close();
  }
  return { ours_ms, word_ms, robots_ms };
}
