// SPDX-License-Identifier: BSD-3-Clause
/** Who is to be told of what, by topic. */
export class Listeners<T> {
  #of = new Map<string, Set<(told: T) => void>>();

  /** Tells `listener` of `topic` until the returned function is called. */
  add(topic: string, listener: (told: T) => void): () => void {
    const listeners = this.#of.get(topic) ?? new Set();
    this.#of.set(topic, listeners.add(listener));
    return () => void listeners.delete(listener);
  }

  tell(topic: string, told: T): void {
    this.#of.get(topic)?.forEach((listener) => listener(told));
  }
}
