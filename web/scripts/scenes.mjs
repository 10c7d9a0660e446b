// SPDX-License-Identifier: BSD-3-Clause
// What there is to see of the page: each scene with the team that tests/fixture plays for it, and what brings it up.
// Every wait in it ends with the page's own time limit.

export const SCREENS = {
  laptop: { width: 1366, height: 768 },
  beamer: { width: 1920, height: 1080 },
  phone: { width: 390, height: 844 },
};
export const THEMES = ["light", "dark"];

const AT_WORK = { ahead: 60 };

const at = (page, testid) => page.getByTestId(testid);
const isNarrow = (page) => page.viewportSize().width < 1000;

/** Brings a panel into sight: by its tab on a phone, by its title where it stands behind another. */
export async function bring(page, panel) {
  if (isNarrow(page)) await at(page, `tab-${panel}`).click();
  else if (!(await page.locator(`[data-panel=${panel}]`).isVisible())) await at(page, `title-${panel}`).click();
}

async function choose(page, robot) {
  await (isNarrow(page) ? at(page, `strip-${robot}`) : at(page, `team-row-${robot}`).locator("button.choose")).click();
}

/** Until so many robots are on the map, and the chosen one's state and picture where there is room for them. */
async function atWork(page, robots = 1) {
  await page.locator("[data-testid^=map-robot-]").nth(robots - 1).waitFor();
  if (isNarrow(page)) return;
  await page.locator("[data-testid^=state-][data-current=true]").waitFor();
  await page.locator("[data-testid=picture-camera][data-shown]:not([data-shown='0'])").waitFor();
}

async function start(page) {
  await page.locator("[data-testid=connection].live").waitFor();
  await page.getByText("No robot has been heard yet").first().waitFor();
}

async function deadRobot(page) {
  await atWork(page);
  await choose(page, "callisto");
  await page.getByText(/silent \d/).first().waitFor();
}

async function deadCamera(page) {
  await bring(page, "vision");
  await at(page, "picture-camera").getByTestId("rate").filter({ hasText: / old$|^no picture for / }).waitFor();
}

async function lagging(page) {
  await page.locator("[data-testid=connection].behind").waitFor();
}

async function past(page) {
  await atWork(page);
  await bring(page, "timeline");
  for (let i = 0; i < 3; i += 1) await page.keyboard.press("ArrowLeft");
  await at(page, "past-notice").waitFor();
}

async function push(page) {
  await bring(page, "program");
  await at(page, "program-select").selectOption("sit_and_spin.bhdl");
  await at(page, "push-button").click();
  await at(page, "program-changes").waitFor();
}

async function instructor(page) {
  await atWork(page);
  const clock = at(page, "instructor-clock");
  // The key is there once the simulation was heard.
  for (let tries = 0; tries < 20 && (await clock.count()) === 0; tries += 1) {
    await page.keyboard.press("i");
    await clock.waitFor({ timeout: 1000 }).catch(() => {});
  }
  await clock.waitFor();
}

async function replay(page) {
  await page.locator("[data-testid=replay] time").waitFor();
  await atWork(page);
  await page.keyboard.press(" ");
  await page.locator("[data-testid=playback][data-status=paused]").waitFor();
}

async function recordings(page) {
  await atWork(page);
  await page.keyboard.press("L");
  await at(page, "recording-office.mcap").waitFor();
}

async function wall(page) {
  await at(page, "wall-robot-io").waitFor();
  await page.locator("[data-testid^=map-robot-]").first().waitFor();
}

async function help(page) {
  await atWork(page);
  await page.keyboard.press("?");
  await at(page, "help").waitFor();
}

async function coverage(page) {
  await bring(page, "machine");
  await at(page, "machine-coverage").click();
  await at(page, "coverage-sentence").waitFor();
}

async function gains(page) {
  await bring(page, "gains");
  await page.locator("[data-gain]").first().waitFor();
}

async function breaks(page) {
  await (isNarrow(page) ? at(page, "strip-io").filter({ hasText: "is stopped" }) : at(page, "break-io")).waitFor();
  await bring(page, "machine");
  await page.keyboard.press("B");
  await at(page, "break-list").locator("[data-change]").first().waitFor();
}

async function tune(page) {
  await bring(page, "vision");
  await at(page, "tune-button").click();
  await page.getByText(/^\d+ blobs? in /).waitFor();
}

async function editor(page) {
  await bring(page, "program");
  await at(page, "edit-button").click();
  await at(page, "program-editor").locator(".cm-content").waitFor();
  if (!isNarrow(page)) await at(page, "editor-graph").locator("[data-state]").first().waitFor();
}

/** `anyTeam`: it can be seen of a live team, too, and tells it nothing. */
export const scenes = [
  { name: "start", play: { empty: true }, show: start },
  { name: "team", play: AT_WORK, show: atWork, anyTeam: true },
  { name: "thick", play: { ...AT_WORK, robots: 30 }, show: (page) => atWork(page, 30) },
  { name: "crowd", play: { ...AT_WORK, robots: 100 }, show: (page) => atWork(page, 100) },
  { name: "dead-robot", play: { ...AT_WORK, silent: "callisto" }, show: deadRobot },
  { name: "dead-camera", play: { ...AT_WORK, blind: "io" }, show: deadCamera },
  { name: "lagging", play: { ...AT_WORK, late: true }, show: lagging },
  { name: "past", play: AT_WORK, show: past, anyTeam: true },
  { name: "push", play: AT_WORK, show: push, anyTeam: true },
  { name: "instructor", play: { ...AT_WORK, simulated: true }, show: instructor, anyTeam: true },
  { name: "wall", play: AT_WORK, path: "/?wall", show: wall, anyTeam: true },
  { name: "replay", play: AT_WORK, path: "/?recording=office.mcap&at=20", show: replay },
  { name: "recordings", play: AT_WORK, show: recordings },
  { name: "help", play: AT_WORK, show: help, anyTeam: true },
  { name: "coverage", play: AT_WORK, show: coverage, anyTeam: true },
  { name: "gains", play: AT_WORK, show: gains, anyTeam: true },
  { name: "breaks", play: { ...AT_WORK, stopping: "io" }, show: breaks },
  { name: "tune", play: AT_WORK, show: tune, anyTeam: true },
  { name: "editor", play: AT_WORK, show: editor, anyTeam: true },
];
