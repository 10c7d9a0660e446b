// SPDX-License-Identifier: BSD-3-Clause
// Which recording the page shows, as its address names it: `/?recording=office.mcap`.

/** Undefined: the page shows the live team. It never changes: another recording is another load of the page. */
export const recording: string | undefined =
  typeof location === "undefined" ? undefined : new URLSearchParams(location.search).get("recording") || undefined;

/** Why nothing can be ordered there. */
export const RECORDED = "This is a recording: a recording cannot be stopped or steered. Go back to the live team to do that.";

/** The path of the WebSocket that plays it. */
export const playedAt = (name: string): string => `/replay?recording=${encodeURIComponent(name)}`;

/** The address of the page that shows it. */
export const shownAt = (name: string): string => `/?recording=${encodeURIComponent(name)}`;
