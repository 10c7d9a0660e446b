// SPDX-License-Identifier: BSD-3-Clause
// Before anything is painted: the colours that the reader chose, and whether the panels stand where index.html shows
// them. It is put into index.html, since a file that has to be fetched keeps the page from being painted for as long. The
// monitor lets run what stands there: monitor/server/http/page_policy.h.
{
  const { documentElement: page } = document;
  const theme = localStorage.getItem("galilean.theme");
  if (theme === "light" || theme === "dark") page.style.colorScheme = theme;
  const query = new URLSearchParams(location.search);
  if (query.has("wall")) page.dataset.starts = "wall";
  else if (query.has("layout") || localStorage.getItem("galilean.layout")) page.dataset.starts = "arranged";
}
