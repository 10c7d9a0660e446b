// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the page as it is: node scripts/screenshot.mjs URL FOLDER [--chromium PATH]
// Light and dark, on a laptop, a large screen and a phone, with the team at work.
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { chromium } from "playwright-core";

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { chromium: { type: "string", default: "/usr/bin/chromium" } },
});
const [url, folder] = positionals;
if (!url || !folder) {
  console.error("usage: node scripts/screenshot.mjs URL FOLDER [--chromium PATH]");
  process.exit(2);
}

const SCREENS = {
  laptop: { width: 1366, height: 768 },
  large: { width: 1920, height: 1080 },
  phone: { width: 390, height: 844 },
};

async function take(browser, screen, colorScheme) {
  const context = await browser.newContext({ viewport: SCREENS[screen], colorScheme, deviceScaleFactor: screen === "phone" ? 2 : 1 });
  const page = await context.newPage();
  page.on("pageerror", (error) => console.error(`${screen} ${colorScheme}: ${error.message}`));
  page.on("console", (message) => message.type() === "error" && console.error(`${screen} ${colorScheme}: ${message.text()}`));
  await page.goto(url);
  await page.locator("[data-testid^=map-robot-]").first().waitFor();
  if (screen !== "phone") {
    await page.locator("[data-testid^=state-][data-current=true]").waitFor();
    await page.locator("[data-testid=picture-camera][data-shown]:not([data-shown='0'])").waitFor();
  }
  const path = join(folder, `${screen}-${colorScheme}.png`);
  await page.screenshot({ path });
  console.log(path);
  await context.close();
}

mkdirSync(folder, { recursive: true });
const browser = await chromium.launch({ executablePath: values.chromium, args: ["--no-sandbox", "--disable-gpu"] });
try {
  for (const screen of Object.keys(SCREENS)) for (const scheme of ["light", "dark"]) await take(browser, screen, scheme);
} finally {
  await browser.close();
}
