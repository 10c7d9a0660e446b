// SPDX-License-Identifier: BSD-3-Clause
import type { Variable } from "../feed/messages";
import { certaintyAt } from "../model/certainty";
import { typeName } from "../model/variable_text";

/** "all", "valid", or a type. */
export type Shown = string;

/** What there is to choose from. */
export function kindsOf(items: readonly Variable[]): Shown[] {
  return ["all", "valid", ...new Set(items.map((variable) => typeName({ ...variable, object_class: "" })))];
}

export function isValidNow({ valid, certainty, decay_per_s }: Variable, age_ms: number): boolean {
  return valid && (decay_per_s === 0 || certaintyAt(certainty, decay_per_s, age_ms) > 0);
}

/** Every word must stand in the name, the type or the class. */
export function isShown(variable: Variable, words: string, shown: Shown, age_ms: number): boolean {
  const type = typeName({ ...variable, object_class: "" });
  const text = `${variable.name} ${typeName(variable)}`.toLowerCase();
  const kind = shown === "all" || shown === type || (shown === "valid" && isValidNow(variable, age_ms));
  return kind && words.toLowerCase().split(/\s+/).every((word) => text.includes(word));
}
