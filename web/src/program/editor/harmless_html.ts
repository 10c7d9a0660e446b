// SPDX-License-Identifier: BSD-3-Clause
const KEPT = new Set(["P", "UL", "OL", "LI", "STRONG", "EM", "CODE", "PRE", "SPAN", "BR", "TABLE", "THEAD", "TBODY", "TR", "TH", "TD"]);

/** HTML without whatever could do something: a program that somebody else wrote is shown in a hover. */
export function harmless(html: string): string {
  const { body } = new DOMParser().parseFromString(html, "text/html");
  for (const element of [...body.querySelectorAll("*")]) {
    if (!KEPT.has(element.tagName)) element.replaceWith(element.textContent ?? "");
    else for (const { name } of [...element.attributes]) if (name !== "class") element.removeAttribute(name);
  }
  return body.innerHTML;
}
