// SPDX-License-Identifier: BSD-3-Clause
// Who may steer which robot, and what this operator does about it. One operator alone is asked and told nothing.

import { changeLease, type LeaseDeed, status } from "../feed/api";
import { nameOperator, operatorName } from "../feed/who";
import { Attempts } from "../lib/attempts.svelte";
import { isSame, type Lease, leaseObjection, type OperatorId } from "./lease";
import { live } from "./live.svelte";

const NONE: readonly Lease[] = [];

export class Leases {
  #me = $state.raw<OperatorId>();
  #attempts = new Attempts();
  /** Robots that this operator gave away or let go by a word of its own: nothing is said of these. */
  #letGo = new Set<string>();
  #before: readonly Lease[] = NONE;

  readonly all: readonly Lease[] = $derived(live.playback ? NONE : (live.present.leases ?? NONE));
  /** What this operator holds and others ask for. */
  readonly asked: readonly Lease[] = $derived(this.all.filter(({ holder, asker }) => asker !== null && isSame(holder, this.#me)));
  /** Whether it must say from time to time that it is there. */
  readonly needsBeat: boolean = $derived(this.all.some(({ holder, asker }) => isSame(holder, this.#me) || isSame(asker, this.#me)));
  /** Whether anybody else steers or wants to. Without them nothing is shown of leases. */
  readonly hasOthers: boolean = $derived(this.all.some(({ holder, asker }) => !isSame(holder, this.#me) || (asker !== null && !isSame(asker, this.#me))));

  /** Whether any robot is held by somebody else. */
  readonly #hasForeign: boolean = $derived(this.all.some(({ holder }) => !isSame(holder, this.#me)));

  /** As the monitor calls this operator; undefined: it may not steer, or is not known yet. */
  get me(): OperatorId | undefined {
    return this.#me;
  }
  get typedName(): string {
    return operatorName();
  }
  get failure(): string | undefined {
    return this.#attempts.failure;
  }

  told(me: OperatorId | null | undefined): void {
    this.#me = me ?? undefined;
  }

  of(robot: string): Lease | undefined {
    return this.all.find((lease) => lease.robot === robot);
  }
  isMine = (lease: Lease): boolean => isSame(lease.holder, this.#me);
  asks = (lease: Lease): boolean => isSame(lease.asker, this.#me);

  /** Why this operator may not steer these robots, and what to do. No names mean the team. */
  objection(robots: readonly string[]): string | undefined {
    return this.#hasForeign ? leaseObjection(live.present, robots, this.#me) : undefined;
  }

  ask(robot: string): void {
    this.#letGo.delete(robot);
    void this.#do("ask", robot, `${robot} was not asked for`);
  }
  give(robot: string): void {
    this.#letGo.add(robot);
    void this.#do("give", robot, `${robot} was not given`);
  }
  refuse(robot: string): void {
    void this.#do("refuse", robot, `Nobody was told that you keep ${robot}`);
  }
  withdraw(robot: string): void {
    this.#letGo.add(robot);
    void this.#do("release", robot, `${robot} is still asked for`);
  }
  take(robot: string, reason: string): void {
    void this.#do("take", robot, `${robot} was not taken over`, reason);
  }

  /** Any request is a word; this one tells who asks, too. */
  async beat(): Promise<void> {
    await status().then(({ operator }) => this.told(operator), () => {});
  }

  /** Lets go what was held under the name before, so that nobody must ask a name that is gone. */
  async rename(name: string): Promise<void> {
    if (name.trim() === operatorName()) return;
    await changeLease("release", []).catch(() => {});
    nameOperator(name);
    await this.beat();
  }

  /** Called with each change: says what this operator lost, and what it was not given. */
  look(): void {
    const [before, now] = [this.#before, this.all];
    this.#before = now;
    for (const was of before) {
      const is = now.find(({ robot }) => robot === was.robot);
      const holder = is?.holder.name;
      const lost = this.isMine(was) && is !== undefined && !this.isMine(is);
      const unanswered = this.asks(was) && is !== undefined && !this.isMine(is) && !this.asks(is);
      if (!lost && !unanswered) continue;
      if (this.#letGo.delete(was.robot)) continue;
      live.trouble = lost ? `${holder} steers ${was.robot} now; the timeline says why.` : `You do not get ${was.robot}: ${holder} holds it.`;
    }
  }

  /** The page goes: whoever waits need not wait for its silence. */
  leave(): void {
    if (this.needsBeat) void changeLease("release", [], undefined, true).catch(() => {});
  }

  async #do(deed: LeaseDeed, robot: string, failed: string, reason?: string): Promise<void> {
    await this.#attempts.make(() => changeLease(deed, [robot], reason), ({ message }) => `${failed}: ${message}`);
  }
}

export const leases = new Leases();
