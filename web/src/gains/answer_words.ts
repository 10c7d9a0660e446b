// SPDX-License-Identifier: BSD-3-Clause
import type { Push } from "../model/model";
import type { Answer } from "./tuner.svelte";

export interface AnswerWords {
  readonly words: string;
  readonly kind: "good" | "quiet" | "alarm";
}

const BAD: Record<string, string> = { rejected: "refused it", rolled_back: "went back", no_answer: "did not answer" };

/** What the robots say of a number that was moved, the newest of what is known; `push` is what the page heard of it since. */
export function answerWords({ replies, failure }: Answer, push: Push | undefined): AnswerWords {
  if (failure) return { words: failure, kind: "alarm" };
  const newest = push && push.replies.size > 0 ? [...push.replies.values()] : replies;
  const bad = newest.filter(({ status }) => status in BAD);
  if (bad.length > 0) return { words: bad.map(({ robot, status, message }) => `${robot} ${BAD[status]}${message && `: ${message}`}`).join("; "), kind: "alarm" };
  if (newest.length === 0) return { words: "sent", kind: "quiet" };
  if (newest.every(({ status }) => status === "confirmed")) return { words: "taken", kind: "good" };
  return { words: newest.some(({ status }) => status === "running") ? "runs, on probation" : "is being built", kind: "quiet" };
}
