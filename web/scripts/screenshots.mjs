// SPDX-License-Identifier: BSD-3-Clause
// Pictures of every scene of the page, on each screen, light and dark, into a folder. It says which it took, and which not.
//   node scripts/screenshots.mjs FOLDER [--url LIVE] [--scenes team,push] [--screens laptop,phone] [--themes light] [--chromium PATH]
// Without --url the team is the one that tests/fixture plays, which needs dist/. All 114 pictures take some minutes.
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { chromium } from "playwright-core";
import { within } from "../../tests/tools/patience.mjs";
import { startFixture } from "../tests/fixture/start.mjs";
import { scenes, SCREENS, THEMES } from "./scenes.mjs";

/** A dead robot is silent from the eighth second on. */
const PATIENCE_MS = 30_000;

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { url: { type: "string" }, scenes: { type: "string" }, screens: { type: "string" }, themes: { type: "string" }, chromium: { type: "string", default: "/usr/bin/chromium" } },
});

function usage(why) {
  console.error(`screenshots.mjs: ${why}\nusage: node scripts/screenshots.mjs FOLDER [--url LIVE] [--scenes NAMES] [--screens NAMES] [--themes NAMES] [--chromium PATH]`);
  process.exit(2);
}

/** Those of `known` that an option names, between commas; without it all. */
function chosen(option, known) {
  const names = values[option]?.split(",") ?? known;
  const unknown = names.filter((name) => !known.includes(name));
  if (unknown.length > 0) usage(`--${option} has no ${unknown.join(", ")}: there are ${known.join(", ")}`);
  return names;
}

function addressOf({ path = "/" }, url) {
  const address = new URL(path, url);
  address.hash = new URL(url).hash; // the token
  return address.href;
}

async function take(browser, scene, { url, screen, theme }) {
  const name = `${scene.name}-${screen}-${theme}`;
  const context = await browser.newContext({ viewport: SCREENS[screen], colorScheme: theme, deviceScaleFactor: screen === "phone" ? 2 : 1 });
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE_MS);
    page.on("pageerror", ({ message }) => console.error(`${name}: ${message}`));
    page.on("console", (message) => message.type() === "error" && console.error(`${name}: ${message.text()}`));
    await page.goto(addressOf(scene, url));
    await scene.show(page);
    const path = join(folder, `${name}.png`);
    await page.screenshot({ path });
    console.log(path);
  } finally {
    await context.close();
  }
}

/** The pictures of one scene; those that could not be taken, each in a sentence. */
async function takeAll(browser, scene, url) {
  const missed = [];
  for (const screen of screens) for (const theme of themes) {
    const name = `${scene.name}-${screen}-${theme}`;
    const taken = within(take(browser, scene, { url, screen, theme }), () => `the scene ${name}`, 2 * PATIENCE_MS);
    await taken.catch(({ message }) => missed.push(`${name} was not taken: ${message.split("\n")[0]}`));
  }
  return missed;
}

async function playAndTake(browser, scene) {
  const team = await within(startFixture(scene.play), () => `a team for the scene ${scene.name}`, PATIENCE_MS);
  try {
    return await takeAll(browser, scene, team.url);
  } finally {
    await team.stop();
  }
}

const [folder] = positionals;
if (!folder) usage("it needs a folder for the pictures");
const wanted = chosen("scenes", scenes.map(({ name }) => name)).map((name) => scenes.find((scene) => scene.name === name));
const [screens, themes] = [chosen("screens", Object.keys(SCREENS)), chosen("themes", THEMES)];
mkdirSync(folder, { recursive: true });

const missed = [];
const browser = await chromium.launch({ executablePath: values.chromium, args: ["--no-sandbox", "--disable-gpu"] });
try {
  for (const scene of wanted) {
    if (values.url && !scene.anyTeam) console.error(`${scene.name} was left out: it is seen of a team that is played, without --url`);
    else missed.push(...(values.url ? await takeAll(browser, scene, values.url) : await playAndTake(browser, scene)));
  }
} finally {
  await within(browser.close(), () => "the browser's end", PATIENCE_MS);
}
for (const sentence of missed) console.error(sentence);
process.exitCode = missed.length > 0 ? 1 : 0;
