// SPDX-License-Identifier: BSD-3-Clause
// What index.html shows is painted before the page itself, which takes longer to read, is begun.

/** A tab in the background paints nothing: it waits no longer than this. */
const PATIENCE_MS = 1000;

/** A frame that was asked for is not on the screen yet: on a slow machine the page's script would compete with it. */
function firstPainted(): Promise<void> {
  return new Promise((resolve) => {
    if (document.hidden) resolve();
    const painted = new PerformanceObserver((entries) => entries.getEntriesByName("first-contentful-paint").length > 0 && resolve());
    painted.observe({ type: "paint", buffered: true });
    setTimeout(resolve, PATIENCE_MS);
  });
}

firstPainted()
  .then(() => import("./page"))
  .catch((error: unknown) => {
    document.getElementById("starting-word")?.replaceChildren("The page could not be read. Load it anew.");
    throw error;
  });
