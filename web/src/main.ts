// SPDX-License-Identifier: BSD-3-Clause
// What index.html shows is painted before the page itself, which takes longer to read, is begun.

/** A tab in the background is given no frame: it waits no longer than this. */
const PATIENCE_MS = 100;

function framePainted(): Promise<void> {
  return new Promise((resolve) => {
    if (document.hidden) resolve();
    requestAnimationFrame(() => setTimeout(resolve));
    setTimeout(resolve, PATIENCE_MS);
  });
}

framePainted()
  .then(() => import("./page"))
  .catch((error: unknown) => {
    document.getElementById("starting-word")?.replaceChildren("The page could not be read. Load it anew.");
    throw error;
  });
