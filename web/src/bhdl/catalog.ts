// SPDX-License-Identifier: BSD-3-Clause
// What a robot says that its programs may name, and what that is to others: the catalog it publishes.

import type { ComponentText } from "./components";
import { quantityOf } from "./quantity";

/** What an attribute is to those who know no component by name: core/catalog/role.h. */
export type Role =
  | "gain"
  | "channel"
  | "sighting"
  | "threshold"
  | "polarity"
  | "least_area"
  | "certainty_at_least"
  | "certainty_below"
  | "distance_at_most"
  | "time_at_least"
  | "camera_height"
  | "camera_forward";

export interface AttributeSpec {
  readonly name: string;
  readonly type?: string;
  readonly unit?: string;
  /** Of a number, in its unit. */
  readonly minimum?: number;
  readonly maximum?: number;
  /** Of a list: the attribute whose values it has one for each of. */
  readonly one_for_each?: string;
  readonly default?: unknown;
  /** Of a name: the type of variable that it means. */
  readonly refers_to?: string;
  /** Of a bit's index: the attribute that names the variable. */
  readonly bit_of?: string;
  readonly role?: string;
  /** The attribute that the role belongs to; of a channel: its name. */
  readonly of?: string;
}

interface ComponentSpec {
  readonly name: string;
  readonly attributes: readonly AttributeSpec[];
}

export class Catalog {
  #components: ReadonlyMap<string, ComponentSpec>;
  /** The pictures that the robot's schemas make, besides the camera's own. */
  readonly channels: readonly string[];

  /** Throws where `json` is no catalog. */
  constructor(json: string) {
    const { components } = JSON.parse(json) as { components: ComponentSpec[] };
    this.#components = new Map(components.map((component) => [component.name, component]));
    const attributes = components.flatMap((component) => component.attributes);
    this.channels = [...new Set(attributes.flatMap(({ role, of }) => (role === "channel" && of ? [of] : [])))];
  }

  attributes(component: string): readonly AttributeSpec[] {
    return this.#components.get(component)?.attributes ?? [];
  }

  /** The first attribute of a component that has the role. */
  attribute(component: string, role: Role): AttributeSpec | undefined {
    return this.attributes(component).find((attribute) => attribute.role === role);
  }

  /** The component that has an attribute of that role. */
  componentWith(role: Role): string | undefined {
    return [...this.#components.keys()].find((name) => this.attribute(name, role));
  }

  /** As the program writes it, or as it is where the program does not; empty where neither says anything. */
  valueOf(component: ComponentText, attribute: string): string {
    const written = component.attributes.get(attribute)?.value;
    return written ?? this.#defaultOf(component.type, attribute);
  }

  /** Of a number, in SI; NaN where a constant stands in its place or nothing does. */
  quantityOf(component: ComponentText, { name, unit = "" }: AttributeSpec): number {
    return quantityOf(this.valueOf(component, name), unit);
  }

  #defaultOf(component: string, attribute: string): string {
    const value = this.attributes(component).find(({ name }) => name === attribute)?.default;
    return value === undefined ? "" : String(value);
  }
}

const read = new Map<string, Catalog | undefined>();

/** The catalog that `json` says, made once for all robots that say the same; undefined where it is none. */
export function catalogOf(json: string): Catalog | undefined {
  if (!read.has(json)) read.set(json, parsed(json));
  return read.get(json);
}

function parsed(json: string): Catalog | undefined {
  try {
    return new Catalog(json);
  } catch {
    return undefined;
  }
}
