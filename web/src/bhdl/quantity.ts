// SPDX-License-Identifier: BSD-3-Clause
// Numbers with units, as programs write them: core/catalog/unit.h.

const TO_SI: { readonly [unit: string]: number } = {
  "": 1,
  m: 1, cm: 0.01, mm: 0.001, in: 0.0254, ft: 0.3048,
  s: 1, ms: 0.001, min: 60,
  deg: Math.PI / 180, rad: 1,
  px: 1, "px^2": 1,
};

/** A number in SI; NaN where the text is none. `unit` counts where the text names none. */
export function quantityOf(text: string, unit: string): number {
  const [, number = "", written = ""] = /^(-?[\d.]+)\s*([\w/^]*)$/.exec(text) ?? [];
  return Number.parseFloat(number) * (TO_SI[written || unit] ?? Number.NaN);
}
