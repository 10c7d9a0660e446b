// SPDX-License-Identifier: BSD-3-Clause
import type { Arrival } from "./feed";
import { type Pause, type Portion, Portions, type Waiting } from "./portions";
import { robotTopicOf, tellsWhatHappens } from "./topics";

export interface Batch extends Portion {
  /** Events that were dropped, because the page had looked at none for too long. */
  readonly dropped: number;
}

/** As many events as thirty robots have in some hours. */
const MOST_EVENTS = 20_000;

/** Of more robots than these, those that nobody looks at are told of in turns, so many at a time, each four times a second. */
export const CROWD = 12;
export const GLANCE_MS = 250;

/** A robot tells its state ten times a second: a pause that is longer is no hiccup. */
const PAUSE_MS = 2000;

/**
 * What came since the page looked last. Of what tells how things stand only the newest is kept, so that a
 * page that could not look for a minute has no more to read than one that looks at each frame; what
 * happened is kept one by one.
 */
export class Inbox {
  /** States by their topic, events each by a key of its own, in the order in which they came. */
  #waiting = new Map<string, Waiting>();
  /**
   * How the robots of a crowd stand that nobody looks at, each by its topics; who waits longest comes first. All of a
   * hundred at once is more than a page draws between two keys of its reader.
   */
  #aside = new Map<string, Map<string, Waiting>>();
  #portions = new Portions();
  #events: string[] = [];
  #eventsEver = 0;
  #dropped = 0;
  #told_ms = 0;
  #isTold = true;
  #robots = new Set<string>();
  /** When each robot told its state last, on this connection. */
  #stated_ms = new Map<string, number>();
  #looked: string | undefined;
  /** When robots of the crowd were told of last. */
  #turn_ms = -Infinity;

  /** `knowsPauses`: all that was sent comes, as it does not of a recording that is played fast. */
  constructor(private readonly knowsPauses = true) {}

  put(arrival: Arrival): void {
    this.#told_ms = Math.max(this.#told_ms, arrival.received_ms);
    if (tellsWhatHappens(arrival.topic)) this.#putEvent(arrival);
    else this.#putState(arrival);
  }

  /** The monitor told its time. */
  told(monitor_ms: number): void {
    this.#told_ms = Math.max(this.#told_ms, monitor_ms);
    this.#isTold = false;
  }

  /** The robot that the page shows whole. */
  lookAt(robot: string | undefined): void {
    this.#looked = robot;
    for (const [topic, waiting] of this.#aside.get(robot ?? "") ?? []) this.#waiting.set(topic, waiting);
    this.#aside.delete(robot ?? "");
  }

  /** In how many milliseconds there is something to be handed over: 0: now; Infinity: nothing waits. */
  due_ms(now_ms: number): number {
    if (!this.#portions.isOver || this.#waiting.size > 0 || !this.#isTold || this.#dropped > 0) return 0;
    return this.#aside.size > 0 ? Math.max(this.#turn_ms + this.#betweenTurns_ms() - now_ms, 0) : Infinity;
  }

  /** Whether something that has happened waits, which is worth more to the page than how things stand. */
  get hasHappened(): boolean {
    return this.#events.length > 0;
  }

  /**
   * The next portion of what waits, decoded; `damaged` is called for what cannot be. At the time Infinity all is due, whoever's
   * turn it is.
   */
  take(damaged: (topic: string, reason: string) => void, now_ms: number): Batch {
    if (this.#portions.isOver) this.#cut(now_ms);
    const batch = { ...this.#portions.take(damaged), dropped: this.#dropped };
    this.#dropped = 0;
    return batch;
  }

  #cut(now_ms: number): void {
    this.#portions.begin(this.#takeDue(now_ms), this.#told_ms);
    [this.#events, this.#isTold] = [[], true];
  }

  #takeDue(now_ms: number): Waiting[] {
    const due = [...this.#waiting.values()];
    this.#waiting.clear();
    // A page that slept is told of as many as had their turns meanwhile: whom it is not told of looks silent.
    const turns = Math.floor((now_ms - this.#turn_ms) / this.#betweenTurns_ms());
    if (this.#aside.size === 0 || turns < 1) return due;
    this.#turn_ms = now_ms === Infinity ? -Infinity : now_ms;
    for (const [robot, states] of [...this.#aside].slice(0, turns * CROWD)) {
      due.push(...states.values());
      this.#aside.delete(robot);
    }
    return due;
  }

  #betweenTurns_ms(): number {
    return (GLANCE_MS * CROWD) / this.#robots.size;
  }

  /** Forgets what waits and the time: another connection begins. */
  clear(): void {
    this.#waiting.clear();
    this.#aside.clear();
    this.#portions.clear();
    this.#stated_ms.clear();
    [this.#events, this.#dropped, this.#told_ms] = [[], 0, 0];
  }

  #putState(arrival: Arrival): void {
    const { robot, kind } = robotTopicOf(arrival.topic) ?? {};
    if (robot !== undefined) this.#robots.add(robot);
    const shelf = this.#shelfOf(robot);
    const before = shelf.get(arrival.topic);
    const count = (before?.count ?? 0) + 1;
    const pauses = [...(before?.pauses ?? []), ...(kind === "state" ? this.#pauseBefore(arrival) : [])];
    // Behind what came before it: an event and the state after it keep their order.
    shelf.delete(arrival.topic);
    shelf.set(arrival.topic, { ...arrival, count, ...(pauses.length > 0 && { pauses }) });
  }

  /** Found where all states pass by: the page itself may have slept, and sees the newest alone. */
  #pauseBefore({ topic, received_ms: to_ms }: Arrival): Pause[] {
    const from_ms = this.#stated_ms.get(topic) ?? to_ms;
    this.#stated_ms.set(topic, to_ms);
    return this.knowsPauses && to_ms - from_ms > PAUSE_MS ? [{ from_ms, to_ms }] : [];
  }

  #shelfOf(robot: string | undefined): Map<string, Waiting> {
    if (robot === undefined || robot === this.#looked || this.#robots.size <= CROWD) return this.#waiting;
    const shelf = this.#aside.get(robot) ?? new Map<string, Waiting>();
    this.#aside.set(robot, shelf);
    return shelf;
  }

  #putEvent(arrival: Arrival): void {
    const key = `event ${this.#eventsEver++}`;
    this.#waiting.set(key, { ...arrival, count: 1 });
    this.#events.push(key);
    if (this.#events.length <= MOST_EVENTS) return;
    this.#waiting.delete(this.#events.shift()!);
    this.#dropped += 1;
  }
}
