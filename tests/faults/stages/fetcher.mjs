// SPDX-License-Identifier: BSD-3-Clause
// node fetcher.mjs: asks over HTTP from within the network in which it is run. Each line of its input is an array of a number, an
// address and options of fetch; each line of its output has the number, the status and the text, or an error.
import { createInterface } from 'node:readline';

async function answer(number, url, { limit_ms, ...options }) {
  try {
    const response = await fetch(url, { ...options, signal: AbortSignal.timeout(limit_ms) });
    return { number, status: response.status, text: await response.text() };
  } catch (error) {
    return { number, error: String(error.cause ?? error) };
  }
}

createInterface({ input: process.stdin }).on('line', async (line) => {
  console.log(JSON.stringify(await answer(...JSON.parse(line))));
});
