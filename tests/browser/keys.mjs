// SPDX-License-Identifier: BSD-3-Clause
// Keys that are pressed one after another as fast as the page takes them: nobody looks at it in between.
const CODES = { Tab: 9, PageUp: 33, PageDown: 34, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40 };
const SHIFT = 8;

/** Returns a function that presses keys, such as ["Tab", "Shift+Tab"], and ends when the page has taken the last. */
export async function keysOf(page) {
  const browser = await page.context().newCDPSession(page);
  const press = (name) => {
    const key = name.replace("Shift+", "");
    const event = { key, code: key, windowsVirtualKeyCode: CODES[key], modifiers: key === name ? 0 : SHIFT };
    return ["rawKeyDown", "keyUp"].map((type) => browser.send("Input.dispatchKeyEvent", { type, ...event }));
  };
  return (names) => Promise.all(names.flatMap(press));
}
