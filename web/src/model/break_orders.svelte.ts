// SPDX-License-Identifier: BSD-3-Clause
// What the operator orders about break points, and what the robots answer. Orders act now, whatever instant is shown.

import { command, orderBreaks } from "../feed/api";
import type { BreakKind, StateChange } from "../feed/parts";
import { Attempts } from "../lib/attempts.svelte";
import { answerTo, changeWords, kindAt } from "./breaks";
import { live } from "./live.svelte";
import { rights } from "./rights.svelte";

/** A robot answers at once; one that has not for so long is named. */
const LATE_MS = 2000;

interface Given {
  readonly id: string;
  readonly at_ms: number;
  /** Who has not answered. */
  readonly waiting: readonly string[];
  /** What it was refused with, by robot. */
  readonly refusals: readonly string[];
}

/** Robots that are told something: `targets` as the monitor takes them, to which an empty list is the team. */
interface Told {
  readonly targets: readonly string[];
  readonly names: readonly string[];
}
type Send = (targets: readonly string[]) => Promise<{ id: string }>;

export class BreakOrders {
  #attempts = $state.raw(new Attempts());
  /** The newest order that the monitor sent. */
  #given = $state.raw<Given>();
  #orders = 0;
  /** Break points are set for the whole team, or for the chosen robot alone. */
  forTeam = $state(false);

  /** What went wrong with the newest order: in whole sentences, until the next one. */
  readonly complaint: string | undefined = $derived.by(() => {
    if (this.#attempts.failure || !this.#given) return this.#attempts.failure;
    const { waiting, refusals, at_ms } = this.#given;
    const late = live.known_present_ms - at_ms > LATE_MS ? waiting.map((name) => `${name} has not answered.`) : [];
    return [...refusals, ...late].join(" ") || undefined;
  });

  dismiss(): void {
    this.#given = undefined;
    this.#attempts = new Attempts();
  }

  /** Sets a break point of that kind, or takes it off where it is one already. */
  toggle(change: StateChange, kind: BreakKind = "stop"): void {
    if (kindAt(live.presentRobot?.breaks?.value, change) === kind) return this.remove(change);
    this.#order(this.#told, (targets) => orderBreaks("set", targets, [{ ...change, kind }]));
  }

  /** Tells those alone that have it: the others would refuse. */
  remove(change: StateChange): void {
    const told = this.#told.names;
    const names = told.filter((name) => kindAt(live.present.robots.get(name)?.breaks?.value, change));
    const whose = this.forTeam ? "No robot has" : `${told[0]} no longer has`;
    if (told.length > 0 && names.length === 0) live.trouble = `${whose} the break point ${changeWords(change)}: somebody may have taken it off.`;
    this.#order({ targets: names, names }, (targets) => orderBreaks("remove", targets, [change]));
  }

  clear(): void {
    this.#order(this.#told, (targets) => orderBreaks("clear", targets));
  }

  letThrough(robot: string, change: StateChange): void {
    this.#order(only(robot), (targets) => orderBreaks("let_through", targets, [change]));
  }

  /** Lets a robot go on until its next change of state; without a name, every robot. */
  step(robot?: string): void {
    this.#order(robot === undefined ? this.#team : only(robot), (targets) => command("step", targets));
  }

  /** Called as time goes on: notes who has answered. */
  refresh(): void {
    const given = this.#given;
    if (!given) return;
    const refusedBy = (name: string) => answerTo(live.present.robots.get(name)?.breaks?.value, given.id)?.refused;
    const answered = given.waiting.filter((name) => refusedBy(name) !== undefined);
    if (answered.length === 0) return;
    const refused = answered.filter(refusedBy).map((name) => `${name} refused: ${refusedBy(name)}.`);
    this.#given = { ...given, waiting: given.waiting.filter((name) => !answered.includes(name)), refusals: [...given.refusals, ...refused] };
  }

  get #team(): Told {
    return { targets: [], names: [...live.present.robots.keys()] };
  }

  get #told(): Told {
    if (this.forTeam) return this.#team;
    return live.presentRobot ? only(live.presentRobot.name) : { targets: [], names: [] };
  }

  #order(told: Told, send: Send): void {
    if (rights.ask() && told.names.length > 0) void this.#give(told, send);
  }

  async #give({ targets, names }: Told, send: Send): Promise<void> {
    this.#given = undefined;
    this.#orders += 1;
    const order = this.#orders;
    const sent = await this.#attempts.make(() => send(targets), ({ message }) => `The robots were not told: ${message}`);
    if (sent && order === this.#orders) this.#given = { id: sent.id, at_ms: Date.now(), waiting: names, refusals: [] };
  }
}

const only = (robot: string): Told => ({ targets: [robot], names: [robot] });

export const breakOrders = new BreakOrders();
