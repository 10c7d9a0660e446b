// SPDX-License-Identifier: BSD-3-Clause
/** Returns a function that has its argument called in a task of its own, behind those that wait already and sooner than any timer. */
export function ownTasks(): (act: () => void) => void {
  const { port1, port2 } = new MessageChannel();
  const waiting: (() => void)[] = [];
  port1.onmessage = () => waiting.shift()?.();
  return (act) => {
    waiting.push(act);
    port2.postMessage(0);
  };
}
