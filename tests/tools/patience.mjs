// SPDX-License-Identifier: BSD-3-Clause
// What a test waits for has an end: nothing waits for longer than this, even on a slow machine.
export const PATIENCE_MS = 120_000;

/** What `promise` gives; if that takes too long, an error that says where it was waited for `what()`. */
export function within(promise, what, patience_ms = PATIENCE_MS) {
  const late = new Error();
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => {
      late.message = `waited ${patience_ms / 1000} s for ${what()}`;
      reject(late);
    }, patience_ms);
    promise.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}

/** Asks again until `question()` gives something truthy. */
export function eventually(question, patience_ms = PATIENCE_MS) {
  let waiting = true;
  const ask = async () => {
    while (waiting) {
      const answer = await question();
      if (answer) return answer;
      await new Promise((resolve) => setImmediate(resolve));
    }
    return undefined;
  };
  return within(ask(), () => `${question} to come true`, patience_ms).finally(() => { waiting = false; });
}
