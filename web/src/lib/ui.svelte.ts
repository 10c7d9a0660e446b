// SPDX-License-Identifier: BSD-3-Clause
// What the reader chose about the page itself.

export type Theme = "system" | "light" | "dark";

const THEME = "galilean.theme";
const NEXT: Record<Theme, Theme> = { system: "dark", dark: "light", light: "system" };

function matches(query: string, told: (matches: boolean) => void): boolean {
  const media = matchMedia(query);
  media.addEventListener("change", () => told(media.matches));
  return media.matches;
}

class Ui {
  theme = $state<Theme>((localStorage.getItem(THEME) as Theme | null) ?? "system");
  #systemDark = $state(matches("(prefers-color-scheme: dark)", (dark) => (this.#systemDark = dark)));
  /** No room for panels side by side: one at a time. */
  narrow = $state(matches("(max-width: 999px)", (narrow) => (this.narrow = narrow)));
  /** The panel that is shown where there is room for one. */
  tab = $state("map");
  /** The force variable that the map picks out of the chosen robot's. */
  litForce = $state<string>();
  helpOpen = $state(false);
  editorOpen = $state(false);
  recordingsOpen = $state(false);

  readonly dark: boolean = $derived(this.theme === "system" ? this.#systemDark : this.theme === "dark");

  constructor() {
    this.#show();
  }

  nextTheme(): void {
    this.theme = NEXT[this.theme];
    localStorage.setItem(THEME, this.theme);
    this.#show();
  }

  #show(): void {
    document.documentElement.style.colorScheme = this.theme === "system" ? "" : this.theme;
  }
}

export const ui = new Ui();
