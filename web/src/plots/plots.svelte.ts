// SPDX-License-Identifier: BSD-3-Clause
// The lines that are plotted, and their samples: the past that the page remembers, and then all that comes.

import type { Variables } from "../feed/messages";
import { live } from "../model/live.svelte";
import { lineKey, type PlotLine, valueOf } from "./quantities";
import { Samples } from "./samples";

/** Lines of one kind of number share a chart. */
export interface Chart {
  readonly title: string;
  readonly unit: string;
  readonly lines: readonly PlotLine[];
}

const MOST_LINES = 12;

class Plots {
  lines = $state.raw<readonly PlotLine[]>([]);
  #samples = new Map<string, Samples>();
  #ends = new Map<string, () => void>();

  constructor() {
    live.onRewind((to_ms) => this.#samples.forEach((samples) => samples.goOnFrom(to_ms)));
  }

  readonly charts: Chart[] = $derived.by(() => {
    const charts = new Map<string, PlotLine[]>();
    for (const line of this.lines) {
      const title = `${line.variable} ${line.quantity}`;
      charts.set(title, [...(charts.get(title) ?? []), line]);
    }
    return [...charts].map(([title, lines]) => ({ title, unit: lines[0]!.unit, lines }));
  });

  has(line: PlotLine): boolean {
    return this.lines.some((each) => lineKey(each) === lineKey(line));
  }

  /** True: it is plotted now. */
  toggle(line: PlotLine): boolean {
    if (this.has(line)) {
      this.remove(line);
      return false;
    }
    if (this.lines.length >= MOST_LINES) this.remove(this.lines[0]!);
    this.#begin(line);
    this.lines = [...this.lines, line];
    return true;
  }

  remove(line: PlotLine): void {
    const key = lineKey(line);
    this.#ends.get(key)?.();
    this.#ends.delete(key);
    this.#samples.delete(key);
    this.lines = this.lines.filter((each) => lineKey(each) !== key);
  }

  samplesOf(line: PlotLine): Samples {
    return this.#samples.get(lineKey(line)) ?? new Samples();
  }

  #begin(line: PlotLine): void {
    const samples = new Samples();
    for (const { team } of live.past) {
      const told = team.robots.get(line.robot)?.variables;
      if (told) samples.add(told.received_ms, valueOf(line, told.value.items));
    }
    const end = live.onMessage(`/${line.robot}/variables`, (message) => samples.add(live.clock_ms, valueOf(line, (message as Variables).items)));
    this.#samples.set(lineKey(line), samples);
    this.#ends.set(lineKey(line), end);
  }
}

export const plots = new Plots();
