// SPDX-License-Identifier: BSD-3-Clause
// What the reader chose to see on the map; it stays so when the panel closes or the page is loaded anew.

import { live } from "../model/live.svelte";

export const forceChoices = ["none", "chosen", "all"] as const;
export const layerNames = {
  trails: "trails of the last minute",
  views: "fields of view",
  sightings: "who sees what now",
  ellipses: "where each may be (86 %)",
  names: "names of robots",
  things: "names of things",
  truth: "truth beside belief (in a simulation)",
} as const;

export type Layer = keyof typeof layerNames;
type Forces = (typeof forceChoices)[number];

interface Kept {
  readonly layers: Record<Layer, boolean>;
  readonly forces: Forces;
}

const KEY = "galilean.map";
const STANDARD: Kept = { layers: { trails: true, views: true, sightings: true, ellipses: true, names: true, things: false, truth: false }, forces: "chosen" };

class MapChoice {
  layers = $state({ ...STANDARD.layers });
  forces = $state<Forces>(STANDARD.forces);
  /** The item whose particulars are shown. */
  item = $state<string>();
  /** The map keeps the chosen robot in its middle. */
  follows = $state(false);

  constructor() {
    const kept = keptChoice();
    Object.assign(this.layers, kept.layers);
    if (forceChoices.includes(kept.forces as Forces)) this.forces = kept.forces as Forces;
  }

  set(layer: Layer, shown: boolean): void {
    this.layers[layer] = shown;
    this.#keep();
  }

  setForces(forces: Forces): void {
    this.forces = forces;
    this.#keep();
  }

  /** Whether the forces of this robot are drawn. */
  showsForcesOf(robot: string): boolean {
    return this.forces === "all" || (this.forces === "chosen" && robot === live.robot?.name);
  }

  #keep(): void {
    localStorage.setItem(KEY, JSON.stringify({ layers: this.layers, forces: this.forces }));
  }
}

function keptChoice(): Partial<Kept> {
  try {
    return (JSON.parse(localStorage.getItem(KEY) ?? "{}") as Partial<Kept> | null) ?? {};
  } catch {
    return {};
  }
}

export const mapChoice = new MapChoice();
