// SPDX-License-Identifier: BSD-3-Clause
// Keeps the address bar at what is looked at: whoever copies the address and opens it elsewhere sees the same.

import { arrangement } from "../layout/arrangement.svelte";
import { live } from "../model/live.svelte";
import { showInstant } from "../model/time_axis.svelte";
import { plots } from "../plots/plots.svelte";
import { CERTAINTY, quantitiesOf } from "../plots/quantities";
import { instantFault, type PlotName, searchOf, type View, viewOf } from "./address";

/** A cursor that is dragged, or keys pressed fast, change the address once. */
const CALM_MS = 400;
/** A recording that plays on changes the address so often. */
const PLAYED_MS = 1000;
/** So long after the first robot was heard, whoever was not is taken for not there. */
const PATIENCE_MS = 5000;

class AddressBar {
  /** What of the address is not shown yet. */
  #wanted = $state.raw<View>();
  #told: readonly string[] = [];
  #heard_ms: number | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  begin(faults: readonly string[] = []): void {
    const read = viewOf(location.search);
    this.#wanted = read.view;
    if (read.view.robot) live.chosen = read.view.robot;
    this.#tell([...faults, ...read.faults]);
  }

  /** Called as the team is heard: shows what the address asks for as soon as it can be shown. */
  settle(): void {
    const wanted = this.#wanted;
    if (!wanted || live.present.robots.size === 0) return;
    const now_ms = live.present_ms;
    this.#heard_ms ??= now_ms;
    const left = wanted.plots.filter((plot) => !this.#plot(plot));
    const isRobotHeard = !wanted.robot || live.present.robots.has(wanted.robot);
    if ((left.length > 0 || !isRobotHeard) && now_ms - this.#heard_ms < PATIENCE_MS) {
      if (left.length < wanted.plots.length) this.#wanted = { ...wanted, plots: left };
      return;
    }
    this.#wanted = undefined;
    this.#tell([
      ...(isRobotHeard ? [] : [`The address asks for the robot ${wanted.robot}, which is not heard.`]),
      ...left.map((plot) => `The address asks for a plot of ${plot.join(" ")}, which nobody tells.`),
      ...(live.isPast || live.chosen !== wanted.robot ? [] : this.#showInstant(wanted.at_ms)),
    ]);
    // Whoever chose another robot meanwhile keeps it.
    if (!isRobotHeard && live.chosen === wanted.robot) live.chosen = undefined;
  }

  /** Called whenever what is looked at changes. */
  refresh(): void {
    const { view } = this;
    if (live.playback) return this.#refreshPlayed();
    clearTimeout(this.#timer);
    if (!this.#wanted) this.#timer = setTimeout(() => this.#write(view), CALM_MS);
  }

  #refreshPlayed(): void {
    this.#timer ??= setTimeout(() => {
      this.#timer = undefined;
      if (!this.#wanted) this.#write(this.view);
    }, PLAYED_MS);
  }

  /** What is looked at. */
  get view(): View {
    const { playback } = live;
    const when = playback ? { recording: { name: playback.name, at_s: playback.position_s } } : { at_ms: live.instant_ms };
    return { robot: live.chosen, ...when, plots: plots.lines.map(({ robot, variable, quantity }): PlotName => [robot, variable, quantity]) };
  }

  /** A link to what is looked at, in that arrangement: it carries no token. */
  link(layout: string | undefined): string {
    return location.origin + location.pathname + searchOf({ ...this.view, layout });
  }

  #write(view: View): void {
    const search = searchOf({ ...view, layout: arrangement.isLinkBroken ? undefined : viewOf(location.search).view.layout });
    if (search !== location.search) history.replaceState(null, "", location.pathname + search);
  }

  #plot([robot, variable, quantity]: PlotName): boolean {
    const told = live.present.robots.get(robot)?.variables?.value.items.find(({ name }) => name === variable);
    if (!told) return false;
    const unit = quantity === CERTAINTY ? "" : quantitiesOf(told).find(({ key }) => key === quantity)?.unit;
    if (unit === undefined) return false;
    const line = { robot, variable, quantity, unit };
    if (!plots.has(line)) plots.toggle(line);
    arrangement.bringForward("plots");
    return true;
  }

  #showInstant(at_ms: number | undefined): string[] {
    if (at_ms === undefined) return [];
    const fault = instantFault(at_ms, live);
    if (fault) return [fault];
    showInstant(at_ms);
    return [];
  }

  #tell(faults: readonly string[]): void {
    if (faults.length === 0) return;
    this.#told = [...this.#told, ...faults];
    live.trouble = this.#told.join(" ");
  }
}

export const addressBar = new AddressBar();
