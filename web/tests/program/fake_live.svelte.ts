// The team as a test says it is.
import { vi } from "vitest";
import type { Program } from "../../src/feed/messages";

/** A robot, as far as the workshop looks at it. */
export function runs(name: string, program: Pick<Program, "name" | "hash" | "files">) {
  return { name, program: { value: program }, state: { value: { program_hash: program.hash } } };
}

class FakeLive {
  robots = $state.raw<ReturnType<typeof runs>[]>([]);
  pushed = vi.fn();
  trouble = $state<string>();
  get robot() {
    return this.robots[0];
  }
  get present() {
    return { robots: new Map(this.robots.map((robot) => [robot.name, robot])) };
  }
}

export const live = new FakeLive();
