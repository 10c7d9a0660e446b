// SPDX-License-Identifier: BSD-3-Clause
// How near a condition is to firing: told where the program says what sets its bit, by a measure that
// runs towards a limit.

import type { Catalog } from "../bhdl/catalog";
import { type ComponentText, componentsOf } from "../bhdl/components";
import { type MachineTransition, type Program, type SourceFile, type Variable, Variable_Constants } from "../feed/messages";
import { lasting, metres, sureness } from "../lib/format";
import { certaintyAt } from "../model/certainty";
import { typeWord } from "../model/variable_text";

/** What a trigger holds against its limit: roles of the catalog. */
const MEASURES = ["certainty_at_least", "certainty_below", "distance_at_most", "time_at_least"] as const;
type Measure = (typeof MEASURES)[number];

/** A schema that sets a bit when a measure passes a limit. */
export interface Trigger {
  readonly measure: Measure;
  readonly schema: string;
  readonly bits: string;
  readonly bit: number;
  /** Of the locate that it watches; empty for a clock. */
  readonly locate: string;
  readonly shaft: string;
  /** A certainty, a distance in metres or a time in seconds. */
  readonly limit: number;
}

/** What is known of the robot now. */
export interface Situation {
  readonly variables: readonly Variable[];
  /** Since the variables were told. */
  readonly age_ms: number;
  readonly in_state_s: number;
  /** Those of the current state. */
  readonly schemas: readonly string[];
}

export interface Nearness {
  /** 0: far from firing, 1: fires. */
  readonly share: number;
  readonly text: string;
}

/** A time left that is shorter than this would be shown as 0.0 s. */
const NOW_S = 0.05;
const FIRES = "fires now";
/** From here on a condition counts as near. */
export const NEAR = 0.75;

function triggerOf(component: ComponentText, catalog: Catalog): Trigger[] {
  const { type, name } = component;
  const attributes = catalog.attributes(type);
  const limit = attributes.find(({ role }) => MEASURES.some((measure) => measure === role));
  const bit = attributes.find(({ bit_of }) => bit_of);
  if (!limit || !bit?.bit_of) return [];
  const value = catalog.quantityOf(component, limit);
  if (!Number.isFinite(value)) return [];
  const shaft = attributes.find(({ refers_to }) => refers_to === typeWord(Variable_Constants.SHAFT));
  return [
    {
      measure: limit.role as Measure,
      schema: name,
      bits: catalog.valueOf(component, bit.bit_of),
      bit: Number.parseInt(catalog.valueOf(component, bit.name), 10),
      locate: limit.of ? catalog.valueOf(component, limit.of) : "",
      shaft: shaft ? catalog.valueOf(component, shaft.name) : "",
      limit: value,
    },
  ];
}

/** Those whose limit stands in the text as a number or in the catalog; constants and bases are not followed. */
export function triggersOf(files: readonly SourceFile[], catalog: Catalog | undefined): Trigger[] {
  return catalog ? componentsOf(files).flatMap((component) => triggerOf(component, catalog)) : [];
}

const share = (value: number): number => Math.min(Math.max(value, 0), 1);

function certaintyOf(name: string, { variables, age_ms }: Situation): { certainty: number; decay_per_s: number } {
  const variable = variables.find((each) => each.name === name);
  if (!variable?.valid) return { certainty: 0, decay_per_s: 0 };
  return { certainty: certaintyAt(variable.certainty, variable.decay_per_s, age_ms), decay_per_s: variable.decay_per_s };
}

function distance_m(trigger: Trigger, { variables }: Situation): number | undefined {
  const object = variables.find(({ name }) => name === trigger.locate);
  const shaft = variables.find(({ name, type }) => (trigger.shaft ? name === trigger.shaft : type === Variable_Constants.SHAFT));
  if (!object?.valid || !shaft?.valid) return undefined;
  return Math.hypot(object.values[0]! - shaft.values[0]!, object.values[1]! - shaft.values[1]!);
}

const measures: Record<Measure, (trigger: Trigger, now: Situation) => Nearness | undefined> = {
  time_at_least: ({ limit }, { in_state_s }) => {
    const left_s = Math.max(limit - in_state_s, 0);
    return { share: share(in_state_s / limit), text: left_s < NOW_S ? FIRES : `in ${lasting(left_s)}` };
  },
  certainty_below: ({ locate, limit }, now) => {
    const { certainty, decay_per_s } = certaintyOf(locate, now);
    if (certainty <= limit) return { share: 1, text: `${FIRES}: ${locate} is not known` };
    const left_s = decay_per_s > 0 ? (certainty - limit) / decay_per_s : Number.POSITIVE_INFINITY;
    const when = Number.isFinite(left_s) ? `, in ${lasting(left_s)} unless it is seen again` : "";
    return { share: share((1 - certainty) / Math.max(1 - limit, 0.01)), text: `sure ${sureness(certainty)}, lost below ${limit}${when}` };
  },
  certainty_at_least: ({ locate, limit }, now) => {
    const { certainty } = certaintyOf(locate, now);
    if (certainty >= limit) return { share: 1, text: `${FIRES}: sure ${sureness(certainty)}, needs ${limit}` };
    return { share: share(certainty / limit), text: certainty > 0 ? `sure ${sureness(certainty)}, needs ${limit}` : `${locate} is not known` };
  },
  distance_at_most: (trigger, now) => {
    const away_m = distance_m(trigger, now);
    if (away_m === undefined) return { share: 0, text: `${trigger.locate} is not known` };
    if (away_m <= trigger.limit) return { share: 1, text: `${FIRES}: ${metres(away_m)} away, fires at ${metres(trigger.limit)}` };
    return { share: share(trigger.limit / Math.max(away_m, 0.01)), text: `${metres(away_m)} away, fires at ${metres(trigger.limit)}` };
  },
};

/** How near; undefined where the bit comes from elsewhere, as from a bumper, or is waited for at 0. */
export function nearnessOf(condition: MachineTransition, triggers: readonly Trigger[], now: Situation): Nearness | undefined {
  if (!condition.bit_value) return undefined;
  const { bits_variable, bit_index } = condition;
  const trigger = triggers.find(({ bits, bit, schema }) => bits === bits_variable && bit === bit_index && now.schemas.includes(schema));
  return trigger && measures[trigger.measure](trigger, now);
}

/** The bit as it is now; undefined while its variable is invalid. */
export function bitNow({ bits_variable, bit_index }: MachineTransition, variables: readonly Variable[]): boolean | undefined {
  const variable = variables.find(({ name }) => name === bits_variable);
  return variable?.valid ? (Math.floor(variable.values[0]! / 2 ** bit_index) & 1) === 1 : undefined;
}

/** What the live robot says of one condition. */
export interface ConditionNow {
  readonly bit: boolean | undefined;
  readonly near: Nearness | undefined;
}

export function conditionNow(condition: MachineTransition, triggers: readonly Trigger[], now: Situation): ConditionNow {
  return { bit: bitNow(condition, now.variables), near: nearnessOf(condition, triggers, now) };
}

/** The schemas of a state: a trigger that does not run there sets nothing. */
export function schemasOf(program: Program, state: string | undefined): readonly string[] {
  return program.states.find(({ name }) => name === state)?.perceptual_schemas ?? [];
}
