// SPDX-License-Identifier: BSD-3-Clause
// What pulls and pushes a robot, as vectors on the map.

import type { Catalog } from "../bhdl/catalog";
import { componentsOf } from "../bhdl/components";
import type { Forces, Program, Variable } from "../feed/messages";

export interface DrawnForce {
  readonly schema: string;
  /** The force variable that it wrote; of a plain sum, empty. */
  readonly variable: string;
  /** In the map's frame, times its gain; no unit. */
  readonly x: number;
  readonly y: number;
  readonly strength: number;
  /** What the others add up to. */
  readonly isSum: boolean;
}

const LEAST = 0.02;
/** The schemas that add up what others suggest: they give gains. */
function combinersOf(program: Program | undefined, catalog: Catalog | undefined): ReadonlySet<string> {
  if (!program || !catalog) return new Set();
  const combiners = componentsOf(program.files).filter(({ type }) => catalog.attribute(type, "gain"));
  return new Set(combiners.map(({ name }) => name));
}

function turned(right: number, ahead: number, heading_rad: number): { x: number; y: number } {
  const [cos, sin] = [Math.cos(heading_rad), Math.sin(heading_rad)];
  return { x: ahead * cos + right * sin, y: ahead * sin - right * cos };
}

/** A force variable by itself, whether a schema that runs writes it or not. */
export function drawnVariable({ name, values }: Variable, heading_rad: number): DrawnForce {
  const [right, ahead] = [values[0] ?? 0, values[1] ?? 0];
  return { schema: name, variable: name, ...turned(right, ahead, heading_rad), strength: Math.hypot(right, ahead), isSum: false };
}

/** The forces of the schemas that run, and their sum as the program's own schema makes it, or plain without one. */
export function drawnForces({ items }: Forces, program: Program | undefined, catalog: Catalog | undefined, heading_rad: number): DrawnForce[] {
  const sums = combinersOf(program, catalog);
  const all = items
    .filter(({ active }) => active)
    .map(({ schema, variable, x, y, gain }): DrawnForce => {
      const isSum = sums.has(schema);
      const [right, ahead] = isSum ? [x, y] : [x * gain, y * gain];
      return { schema, variable, ...turned(right, ahead, heading_rad), strength: Math.hypot(right, ahead), isSum };
    });
  const drawn = all.filter(({ strength }) => strength >= LEAST);
  return all.some(({ isSum }) => isSum) || drawn.length === 0 ? drawn : [...drawn, plainSum(drawn)];
}

function plainSum(forces: readonly DrawnForce[]): DrawnForce {
  const x = forces.reduce((sum, force) => sum + force.x, 0);
  const y = forces.reduce((sum, force) => sum + force.y, 0);
  return { schema: "sum", variable: "", x, y, strength: Math.hypot(x, y), isSum: true };
}
