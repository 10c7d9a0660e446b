// The monitor's HTTP operations. Every failure is an Error whose message can be shown as it stands.

import type { Diagnostic, Machine, SourceFile } from "../feed/messages";
import type { Reply } from "../team/model";

export interface ProgramEntry {
  name: string;
  source: string;
  hash?: string;
}

export interface CheckResult {
  ok: boolean;
  hash: string;
  diagnostics: Diagnostic[];
  machine?: Machine;
}

export interface PushResult {
  id: string;
  hash: string;
  replies: Reply[];
}

/** A program that somebody pushed before, by the hash that tells it from others of its name. */
export interface PushedProgram {
  program: string;
  hash: string;
  author: string;
  pushed_ns: number;
}

/** What the monitor objects to; of a program, with every place. */
export class Refusal extends Error {
  constructor(
    message: string,
    readonly diagnostics: readonly Diagnostic[] = [],
  ) {
    super(message);
  }
}

interface Problem {
  title?: string;
  detail?: string;
  diagnostics?: Diagnostic[];
}

export type CommandKind = "hold" | "resume" | "push_bumper";

async function call<T>(path: string, body?: unknown): Promise<T> {
  const headers = { "content-type": "application/json" };
  const request: RequestInit = body === undefined ? {} : { method: "POST", headers, body: JSON.stringify(body) };
  let response: Response;
  try {
    response = await fetch(path, request);
  } catch {
    throw new Refusal("The monitor does not answer.");
  }
  if (response.ok) return (await response.json()) as T;
  const problem = (await response.json().catch(() => ({}))) as Problem;
  const sentence = problem.detail || problem.title || `The monitor answered ${response.status}.`;
  throw new Refusal(sentence, problem.diagnostics);
}

export async function listPrograms(): Promise<ProgramEntry[]> {
  return (await call<{ programs: ProgramEntry[] }>("/api/programs")).programs;
}

export async function readProgram(name: string): Promise<SourceFile[]> {
  const path = `/api/programs/${name.split("/").map(encodeURIComponent).join("/")}`;
  return (await call<{ files: SourceFile[] }>(path)).files;
}

export async function listPushed(): Promise<PushedProgram[]> {
  return (await call<{ pushes: PushedProgram[] }>("/api/pushes")).pushes;
}

export async function readPushed(hash: string): Promise<SourceFile[]> {
  return (await call<{ files: SourceFile[] }>(`/api/pushed/${hash}`)).files;
}

export function check(files: readonly SourceFile[], robot?: string): Promise<CheckResult> {
  return call("/api/check", { files, ...(robot && { robot }) });
}

/** Empty `targets` mean the whole team. */
export function push(files: readonly SourceFile[], targets: readonly string[]): Promise<PushResult> {
  return call("/api/push", { files, targets, author: "operator" });
}

export function command(kind: CommandKind, targets: readonly string[], argument = 0): Promise<{ id: string }> {
  return call("/api/command", { kind, targets, argument });
}

export function status(): Promise<{ name: string; scenario: string; version: string }> {
  return call("/api/status");
}
