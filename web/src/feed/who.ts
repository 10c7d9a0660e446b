// SPDX-License-Identifier: BSD-3-Clause
// Who this page's operator is to the monitor and to other operators: a tab, and a name where one was typed.

const CLIENT = "galilean.client";
const NAME = "galilean.operator";
/** What the monitor keeps of a name. */
export const LONGEST_NAME = 64;

type Store = Pick<Storage, "getItem" | "setItem">;

/** An id that no other has. `crypto.randomUUID` is not there on a page that came over plain HTTP from another machine. */
export function newId(): string {
  return [...crypto.getRandomValues(new Uint8Array(8))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}

/** The tab's id: as long as the tab is open, also when the page is loaded anew. */
export function takeClient(tab: Store): string {
  const kept = tab.getItem(CLIENT);
  if (kept) return kept;
  const made = newId();
  tab.setItem(CLIENT, made);
  return made;
}

/** A new tab takes the name that was typed last in this browser. */
export function takeName(tab: Store, browser: Store): string {
  return tab.getItem(NAME) ?? browser.getItem(NAME) ?? "";
}

const isBrowser = typeof localStorage !== "undefined" && typeof sessionStorage !== "undefined" && "setItem" in sessionStorage;
const client = isBrowser ? takeClient(sessionStorage) : "";
let name = isBrowser ? takeName(sessionStorage, localStorage) : "";

/** Empty: the monitor finds one. */
export const operatorName = (): string => name;

export function nameOperator(typed: string): void {
  name = typed.trim().slice(0, LONGEST_NAME);
  if (!isBrowser) return;
  sessionStorage.setItem(NAME, name);
  localStorage.setItem(NAME, name);
}

/** What a request says of its sender. A header has no letters beyond ASCII, so that the name is percent-encoded. */
export function introduction(): Record<string, string> {
  return { ...(name && { "x-galilean-operator": encodeURIComponent(name) }), ...(client && { "x-galilean-client": client }) };
}
