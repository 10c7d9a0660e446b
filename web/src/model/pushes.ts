// SPDX-License-Identifier: BSD-3-Clause
import { type ProgramPush, type ProgramReply, ProgramReply_Constants, type PushProgress } from "../feed/messages";
import { namesOf } from "../feed/parts";
import type { Reply } from "../feed/api";
import type { Push } from "./model";

const KEPT = 8;
/** What a robot answers, as the monitor calls it; later answers say more. */
const STATUSES = namesOf(ProgramReply_Constants);
const RANK: readonly (string | undefined)[] = STATUSES;

export function fileName(path: string): string {
  return path.split("/").at(-1) ?? path;
}

/** What is told of a push as it begins. */
type Begun = Pick<ProgramPush, "id" | "author" | "files" | "hash" | "targets">;

export function withPush(pushes: readonly Push[], { id, author, files, hash, targets }: Begun, at_ms: number): readonly Push[] {
  const known = pushes.find((push) => push.id === id);
  const push: Push = {
    id,
    author,
    name: fileName(files[0]?.path ?? ""),
    hash,
    targets,
    at_ms: known?.at_ms ?? at_ms,
    answered_ms: known?.answered_ms ?? at_ms,
    replies: known?.replies ?? new Map(),
    state: known?.state ?? "",
    steps: known?.steps ?? [],
  };
  return [...pushes.filter((other) => other.id !== id), push].slice(-KEPT);
}

const OPEN = new Set(["", "running", "interrupted"]);

/** How a push that was interrupted or failed ends once its robots have told that they run it. */
export const TOLD_LATER = "told_later";

/** The pushes with how far one of them has come; what is over stays so, unless its robots told later that they run it. */
export function withProgress(pushes: readonly Push[], id: string, { state, steps }: Pick<Push, "state" | "steps">): readonly Push[] {
  return pushes.map((push) => (push.id === id && (OPEN.has(push.state) || state === TOLD_LATER) ? { ...push, state, steps } : push));
}

/**
 * The pushes as they are known on a new connection: a monitor that still brings one to its robots says so again, and one
 * that was started anew has dropped it.
 */
export function withInterrupted(pushes: readonly Push[]): readonly Push[] {
  return pushes.map((push) => (push.state === "running" ? { ...push, state: "interrupted" } : push));
}

/** A push that the monitor tells of before its robots are sent anything. */
export function withStep(pushes: readonly Push[], told: PushProgress, at_ms: number): readonly Push[] {
  const { id, author, program: path, hash, targets } = told;
  const known = pushes.some((push) => push.id === id);
  const all = known ? pushes : withPush(pushes, { id, author, hash, targets, files: [{ path, text: "" }] }, at_ms);
  return withProgress(all, id, told);
}

/** The pushes with a robot's answer; an answer that says less than the one before it came late and is dropped. */
export function withReply(pushes: readonly Push[], id: string, reply: Reply, at_ms: number): readonly Push[] {
  return pushes.map((push) => {
    if (push.id !== id) return push;
    const before = push.replies.get(reply.robot);
    if (before && RANK.indexOf(before.status) > RANK.indexOf(reply.status)) return push;
    const merged = { ...reply, latency_ms: reply.latency_ms ?? before?.latency_ms };
    return { ...push, answered_ms: Math.max(push.answered_ms, at_ms), replies: new Map(push.replies).set(reply.robot, merged) };
  });
}

export function replyOf(message: ProgramReply): Reply {
  return { ...message, status: STATUSES[message.status] ?? "no_answer" };
}
