// SPDX-License-Identifier: BSD-3-Clause
import type { Arrival } from "./feed";
import { robotTopicOf, tellsWhatHappens } from "./topics";

/** A message that the page has not seen yet. */
export interface News {
  readonly topic: string;
  readonly message: unknown;
  readonly received_ms: number;
  /** How many messages came on the topic since the last one that the page saw; this is the newest. */
  readonly count: number;
}

export interface Batch {
  /** What the page knows then is what the monitor knew at this time, on the page's clock. */
  readonly told_ms: number;
  /** In the order in which they came. */
  readonly news: readonly News[];
  /** Events that were dropped, because the page had looked at none for too long. */
  readonly dropped: number;
}

/** As many events as thirty robots have in some hours. */
const MOST_EVENTS = 20_000;

/** Of more robots than these, those that nobody looks at are told of four times a second. */
export const CROWD = 12;
export const GLANCE_MS = 250;

interface Waiting extends Arrival {
  readonly count: number;
}

/**
 * What came since the page looked last. Of what tells how things stand only the newest is kept, so that a
 * page that could not look for a minute has no more to read than one that looks at each frame; what
 * happened is kept one by one.
 */
export class Inbox {
  /** States by their topic, events each by a key of its own, in the order in which they came. */
  #waiting = new Map<string, Waiting>();
  #events: string[] = [];
  #eventsEver = 0;
  #dropped = 0;
  #told_ms = 0;
  #robots = new Set<string>();
  #looked: string | undefined;
  /** When the page was handed all that waited. */
  #emptied_ms = 0;

  put(arrival: Arrival): void {
    this.told(arrival.received_ms);
    if (tellsWhatHappens(arrival.topic)) this.#putEvent(arrival);
    else this.#putState(arrival);
  }

  /** The monitor told its time. */
  told(monitor_ms: number): void {
    this.#told_ms = Math.max(this.#told_ms, monitor_ms);
  }

  /** The robot that the page shows whole. */
  lookAt(robot: string | undefined): void {
    this.#looked = robot;
  }

  /**
   * What waits, decoded; `damaged` is called for what cannot be. How the robots of a crowd stand that nobody looks at
   * waits longer: to decode and hand over what is new of a hundred, ten times a second, is all that a slow machine can do.
   */
  take(damaged: (topic: string, reason: string) => void, now_ms: number): Batch {
    const news: News[] = [];
    const isAll = this.#robots.size <= CROWD || now_ms - this.#emptied_ms >= GLANCE_MS;
    if (isAll) this.#emptied_ms = now_ms;
    for (const [key, { topic, decode, received_ms, count }] of this.#waiting) {
      if (!isAll && this.#isAside(topic)) continue;
      this.#waiting.delete(key);
      try {
        news.push({ topic, message: decode(), received_ms, count });
      } catch (error) {
        damaged(topic, (error as Error).message);
      }
    }
    const batch = { told_ms: this.#told_ms, news, dropped: this.#dropped };
    [this.#events, this.#dropped] = [[], 0];
    return batch;
  }

  #isAside(topic: string): boolean {
    const robot = robotTopicOf(topic)?.robot;
    return robot !== undefined && robot !== this.#looked && !tellsWhatHappens(topic);
  }

  /** Forgets what waits and the time: another connection begins. */
  clear(): void {
    this.#waiting.clear();
    [this.#events, this.#dropped, this.#told_ms] = [[], 0, 0];
  }

  #putState(arrival: Arrival): void {
    const robot = robotTopicOf(arrival.topic)?.robot;
    if (robot !== undefined) this.#robots.add(robot);
    const count = (this.#waiting.get(arrival.topic)?.count ?? 0) + 1;
    // Behind what came before it: an event and the state after it keep their order.
    this.#waiting.delete(arrival.topic);
    this.#waiting.set(arrival.topic, { ...arrival, count });
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
