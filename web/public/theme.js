// SPDX-License-Identifier: BSD-3-Clause
// Before anything is painted: the colours that the reader chose, and whether the panels stand where index.html shows
// them. A file of its own, since the monitor's policy lets no script stand in the page.
{
  const { documentElement: page } = document;
  const theme = localStorage.getItem("galilean.theme");
  if (theme === "light" || theme === "dark") page.style.colorScheme = theme;
  const query = new URLSearchParams(location.search);
  if (query.has("wall")) page.dataset.starts = "wall";
  else if (query.has("layout") || localStorage.getItem("galilean.layout")) page.dataset.starts = "arranged";
}
