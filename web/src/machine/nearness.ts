// How near a condition is to firing: told where the program says what sets its bit, by a measure that
// runs towards a limit.

import { type ComponentText, componentsOf } from "../bhdl/components";
import type { MachineTransition, Program, SourceFile, Variable } from "../feed/messages";
import { lasting, metres } from "../lib/format";
import { certaintyAt } from "../model/certainty";

/** A schema that sets a bit when a measure passes a limit. */
export interface Trigger {
  readonly type: "seen" | "lost" | "arrived" | "time_detector";
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
  readonly words: string;
}

/** From here on a condition counts as near. */
export const NEAR = 0.75;

const LIMIT = { seen: "min_certainty", lost: "min_certainty", arrived: "radius", time_detector: "duration" } as const;

type Units = { readonly bare: number; readonly [unit: string]: number };
const LENGTHS: Units = { bare: 0.01, m: 1, cm: 0.01, mm: 0.001, in: 0.0254, ft: 0.3048 };
const TIMES: Units = { bare: 1, s: 1, ms: 0.001, min: 60 };

/** A number as a program writes it, in SI; not a number where it is none. */
function quantity(text: string, units: Units): number {
  const [, number = "", unit = ""] = /^([\d.]+)\s*(\w*)$/.exec(text) ?? [];
  return Number.parseFloat(number) * (units[unit || "bare"] ?? Number.NaN);
}

function triggerOf(component: ComponentText): Trigger[] {
  const { type, name, attributes } = component;
  if (!(type in LIMIT)) return [];
  const kind = type as Trigger["type"];
  const text = (attribute: string) => attributes.get(attribute)?.value ?? "";
  const limit = quantity(text(LIMIT[kind]), kind === "arrived" ? LENGTHS : TIMES);
  if (!Number.isFinite(limit)) return [];
  const bit = Number.parseInt(text("bit_index") || "0", 10);
  return [{ type: kind, schema: name, bits: text("bits_variable"), bit, locate: text("locate_variable"), shaft: text("shaft_variable"), limit }];
}

/** Those whose limit stands in the text as a number; constants and bases are not followed. */
export function triggersOf(files: readonly SourceFile[]): Trigger[] {
  return componentsOf(files).flatMap(triggerOf);
}

const share = (value: number): number => Math.min(Math.max(value, 0), 1);

function certaintyOf(name: string, { variables, age_ms }: Situation): { certainty: number; decay_per_s: number } {
  const variable = variables.find((each) => each.name === name);
  if (!variable?.valid) return { certainty: 0, decay_per_s: 0 };
  return { certainty: certaintyAt(variable.certainty, variable.decay_per_s, age_ms), decay_per_s: variable.decay_per_s };
}

function distance_m(trigger: Trigger, { variables }: Situation): number | undefined {
  const object = variables.find(({ name }) => name === trigger.locate);
  const shaft = variables.find(({ name, type }) => (trigger.shaft ? name === trigger.shaft : type === 1));
  if (!object?.valid || !shaft?.valid) return undefined;
  return Math.hypot(object.values[0]! - shaft.values[0]!, object.values[1]! - shaft.values[1]!);
}

const measures: Record<Trigger["type"], (trigger: Trigger, now: Situation) => Nearness | undefined> = {
  time_detector: ({ limit }, { in_state_s }) => {
    const left_s = Math.max(limit - in_state_s, 0);
    return { share: share(in_state_s / limit), words: `in ${lasting(left_s)}` };
  },
  lost: ({ locate, limit }, now) => {
    const { certainty, decay_per_s } = certaintyOf(locate, now);
    if (certainty <= limit) return { share: 1, words: `${locate} is not known` };
    const left_s = decay_per_s > 0 ? (certainty - limit) / decay_per_s : Number.POSITIVE_INFINITY;
    const when = Number.isFinite(left_s) ? `, in ${lasting(left_s)} unless it is seen again` : "";
    return { share: share((1 - certainty) / Math.max(1 - limit, 0.01)), words: `sure ${certainty.toFixed(2)}, lost below ${limit}${when}` };
  },
  seen: ({ locate, limit }, now) => {
    const { certainty } = certaintyOf(locate, now);
    return { share: share(certainty / limit), words: certainty > 0 ? `sure ${certainty.toFixed(2)}, needs ${limit}` : `${locate} is not known` };
  },
  arrived: (trigger, now) => {
    const away_m = distance_m(trigger, now);
    if (away_m === undefined) return { share: 0, words: `${trigger.locate} is not known` };
    return { share: share(trigger.limit / Math.max(away_m, 0.01)), words: `${metres(away_m)} away, fires at ${metres(trigger.limit)}` };
  },
};

/** How near; undefined where the bit comes from elsewhere, as from a bumper, or is waited for at 0. */
export function nearnessOf(condition: MachineTransition, triggers: readonly Trigger[], now: Situation): Nearness | undefined {
  if (!condition.bit_value) return undefined;
  const { bits_variable, bit_index } = condition;
  const trigger = triggers.find(({ bits, bit, schema }) => bits === bits_variable && bit === bit_index && now.schemas.includes(schema));
  return trigger && measures[trigger.type](trigger, now);
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
