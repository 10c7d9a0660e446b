// SPDX-License-Identifier: BSD-3-Clause
import { type ProgramReply, ProgramReply_Constants } from "../feed/messages";
import { live } from "../model/live.svelte";

/** Hears whether robots keep what is pushed to them. It is made before the push is sent, so that it misses no answer. */
export class ProbationWatch {
  #told: ProgramReply[] = [];
  #heard = () => {};
  readonly #ends: readonly (() => void)[];

  constructor(robots: readonly string[]) {
    this.#ends = robots.map((robot) =>
      live.onMessage(`/${robot}/program_reply`, (reply) => {
        this.#told.push(reply as ProgramReply);
        this.#heard();
      }),
    );
  }

  /**
   * Whether the robots keep the push: they do once one of them confirms it, and do not once each of them has gone back.
   * Never answers where another push takes its place before.
   */
  outcome(id: string, robots: readonly string[]): Promise<boolean> {
    return new Promise((resolve) => {
      const robotsThat = (status: number) => new Set(this.#told.filter((reply) => reply.id === id && reply.status === status).map(({ robot }) => robot));
      this.#heard = () => {
        const isKept = robotsThat(ProgramReply_Constants.CONFIRMED).size > 0;
        const gone = robotsThat(ProgramReply_Constants.ROLLED_BACK);
        if (!isKept && !robots.every((robot) => gone.has(robot))) return;
        this.end();
        resolve(isKept);
      };
      this.#heard();
    });
  }

  end(): void {
    this.#ends.forEach((end) => end());
    this.#heard = () => {};
  }
}
