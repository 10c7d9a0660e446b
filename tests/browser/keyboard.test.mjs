// SPDX-License-Identifier: BSD-3-Clause
// The keyboard alone reaches everything that can be clicked: by Tab, or from there by the keys of its group.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { scenes, SCREENS } from "../../web/scripts/scenes.mjs";
import { keysOf } from "./keys.mjs";
import { launch, startFixture, Tab } from "./tab.mjs";

/** What a click does there, keys do elsewhere. */
const OTHERWISE = [
  "#page", // hears the clicks of all within it
  ".ground", // of the map: Enter on its items, and the button that closes what is known of one
  ".u-over", // of a plot: the timeline's arrow keys choose an instant
  ".cm-gutter", // of the editor: Ctrl+Shift+[ and ] fold
];
const KEYS = ["ArrowRight", "ArrowDown", "ArrowLeft", "ArrowUp", "PageDown", "PageUp", "Tab", "Shift+Tab"];
const ROUNDS = 5;
/** So many places of groups are tried, and so often is Tab pressed, before the test looks at the page again. */
const PLACES_AT_ONCE = 4, TABS_AT_ONCE = 20;

/** In the page: notes what hears clicks, and what the keyboard has been at. `keys`: that are tried at a place. */
function watchKeyboard({ otherwise, keys }) {
  const ACTS = "button, a[href], input, select, textarea, summary, [contenteditable=true], [role=button], [role=tab], [role=link], [role=menuitem]";
  const GROUPS = "[role=tablist], [role=group], [role=radiogroup], fieldset, svg";
  const [hearing, been, names, tried] = [new WeakSet(), new WeakSet(), new Set(), new Set()];
  const { addEventListener } = EventTarget.prototype;
  EventTarget.prototype.addEventListener = function (type, ...rest) {
    if (type === "click" && this instanceof Element) hearing.add(this);
    return addEventListener.call(this, type, ...rest);
  };
  // What is drawn anew, in another place or at another time, is the same to who looks at it.
  const wordsOf = (element) => {
    const copy = element.cloneNode(true);
    copy.querySelectorAll("time").forEach((time) => time.remove());
    return (element.title + copy.textContent).replace(/[\d.,]+/g, "#").slice(0, 60);
  };
  const nameOf = (element) => {
    const { dataset } = element;
    const own = dataset.testid ?? dataset.item ?? dataset.arrow;
    if (own) return `${element.tagName} ${own}`;
    const around = element.closest("[data-testid]")?.dataset.testid ?? element.closest("[data-panel]")?.dataset.panel;
    return [around, element.tagName, element.getAttribute("aria-label") ?? wordsOf(element)].join(" ");
  };
  document.addEventListener("focusin", ({ target }) => (been.add(target), names.add(nameOf(target))), true);

  /** Svelte keeps what hears clicks on the element itself. */
  const isHeard = (element) => hearing.has(element) || "__click" in element || Object.getOwnPropertySymbols(element).some((symbol) => element[symbol]?.click);
  const isThere = (element) =>
    !element.disabled && !element.closest("[inert]") && element.checkVisibility({ visibilityProperty: true }) && element.getBoundingClientRect().width > 0;
  const isReached = (element) => been.has(element) || names.has(nameOf(element));
  const all = () => [...document.body.querySelectorAll("*")].filter((element) => (element.matches(ACTS) || isHeard(element)) && isThere(element) && !otherwise.some((each) => element.matches(each)));
  const left = () => all().filter((element) => !isReached(element));

  let [places, pressed] = [[], 0];
  const back = () => places[Math.floor(pressed / keys)]?.focus();
  document.addEventListener("keyup", () => ((pressed += 1), back()), true);

  window.keyboard = {
    count: () => all().length,
    left: () => left().map((element) => `${nameOf(element)}: ${element.outerHTML.slice(0, 160)}`),
    /**
     * Puts the keyboard where it has been, in groups of which something is left: at one place before each key, and at
     * the next after all `keys`. Returns how many untried places there are, up to `most`.
     */
    tryNext(most) {
      const groups = new Set(left().map((element) => element.parentElement.closest(GROUPS)).filter(Boolean));
      const reached = [...groups].flatMap((group) => [...group.querySelectorAll("[tabindex], button, input")]).filter((element) => isReached(element) && isThere(element));
      [places, pressed] = [[], 0];
      for (const element of reached) {
        if (places.length === most) break;
        if (!tried.has(nameOf(element))) places.push(element);
        tried.add(nameOf(element));
      }
      back();
      return places.length;
    },
    begin: () => (tried.clear(), (places = []), document.activeElement?.blur()),
  };
}

/** Once round the page. In a text Tab indents until it is told to leave, so that each Tab there is looked at. */
async function goRound(page, press) {
  await page.evaluate(() => window.keyboard.begin());
  const presses = (await page.evaluate(() => window.keyboard.count())) + 40;
  const atOnce = (await page.locator(".cm-content").count()) > 0 ? 1 : TABS_AT_ONCE;
  for (let i = 0; i < presses; i += atOnce) {
    await press(Array(atOnce).fill("Tab"));
    if (await page.evaluate(() => document.activeElement?.matches(".cm-content"))) await page.keyboard.press("Control+m");
  }
}

/** From each place of a group by the keys of the group. */
async function goWithin(page, press, isPast) {
  for (;;) {
    const places = await page.evaluate((most) => window.keyboard.tryNext(most), PLACES_AT_ONCE);
    if (places === 0) return;
    await press(Array(places).fill(KEYS).flat());
    if (!isPast && (await page.getByTestId("past-notice").count()) > 0) await page.keyboard.press("l");
  }
}

async function unreached(page, isPast) {
  const press = await keysOf(page);
  const left = () => page.evaluate(() => window.keyboard.left());
  for (let round = 0; round < ROUNDS; round += 1) {
    await goRound(page, press);
    await goWithin(page, press, isPast);
    if ((await left()).length === 0) break;
  }
  return left();
}

/** The team stands still, so that nothing on its map moves on while the keyboard looks for it. */
async function standStill(tab) {
  if ((await tab.api("/watched")).topics.includes("/simulation/state")) await tab.api("/api/simulation/orders", { order: "pause" });
}

let browser;
before(async () => (browser = await launch()));
after(() => browser?.close());

async function assertReached(scene, viewport) {
  const tab = new Tab();
  tab.fixture = await startFixture({ ...scene.play, simulated: true });
  try {
    await tab.open("about:blank", { viewport, browser });
    await tab.page.addInitScript(watchKeyboard, { otherwise: OTHERWISE, keys: KEYS.length });
    tab.url = new URL(scene.path ?? "/", tab.fixture.url).href;
    await tab.page.goto(tab.url);
    await scene.show(tab.page);
    await standStill(tab);
    const count = await tab.page.evaluate(() => window.keyboard.count());
    assert.ok(count > 20, `only ${count} things can be clicked`);
    assert.deepEqual(await unreached(tab.page, scene.name === "past"), []);
  } finally {
    await tab.close();
    await tab.fixture.stop();
  }
}

/** Of what has nothing more to click than the team's page: one of these would show no other fault. */
const SAME = new Set(["thick", "dead-camera", "lagging", "wall"]);

for (const scene of scenes.filter(({ name }) => !SAME.has(name))) test(`${scene.name}: the keyboard reaches all that can be clicked`, () => assertReached(scene, SCREENS.laptop));
test("on a phone's screen, too", () => assertReached(scenes.find(({ name }) => name === "team"), SCREENS.phone));
