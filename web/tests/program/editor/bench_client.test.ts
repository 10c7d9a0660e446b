// SPDX-License-Identifier: BSD-3-Clause
import type { Transport } from "@codemirror/lsp-client";
import { beforeEach, expect, it, vi } from "vitest";
import { BenchClient } from "../../../src/program/editor/bench_client";

const A = "file:///a.bhdl";
const asked = { textDocument: { uri: A } };

/** A server that answers `initialize`, and the rest when the test says so. */
class SlowServer implements Transport {
  versions: number[] = [];
  #waiting: number[] = [];
  #handle: (message: string) => void = () => {};
  send(text: string): void {
    const { id, method, params } = JSON.parse(text) as { id?: number; method: string; params: { textDocument: { version: number } } };
    if (method === "initialize") this.#tell(id!, { capabilities: { textDocumentSync: 2 } });
    else if (id !== undefined) this.#waiting.push(id);
    else if (/did(Open|Change)/.test(method)) this.versions.push(params.textDocument.version);
  }
  answer(result: unknown): void {
    this.#waiting.splice(0).forEach((id) => this.#tell(id, result));
  }
  subscribe(handler: (message: string) => void): void {
    this.#handle = handler;
  }
  unsubscribe(): void {}
  #tell(id: number, result: unknown): void {
    this.#handle(JSON.stringify({ jsonrpc: "2.0", id, result }));
  }
}

let server: SlowServer;
let client: BenchClient;
const edit = () => client.files.updateFile(A, { changes: { from: 0, insert: "; " } });
const asking = async (method: string) => {
  const answer = client.request(method, asked);
  answer.catch(() => {});
  await Promise.resolve();
  await Promise.resolve();
  return { answer };
};
beforeEach(async () => {
  server = new SlowServer();
  client = new BenchClient({ display: () => Promise.resolve(null), edited: () => {} }, {});
  client.files.put([{ path: "a.bhdl", text: "a" }]);
  await client.connect(server).initializing;
});

it.each(["textDocument/formatting", "textDocument/rename"])("does not let %s change a text that was edited meanwhile, and says so", async (method) => {
  const { answer } = await asking(method);
  edit();
  server.answer([{}]);
  await expect(answer).rejects.toThrow("edited meanwhile");
});

it.each(["textDocument/formatting", "textDocument/rename"])("gives the answer to %s of the text that stands", async (method) => {
  const { answer } = await asking(method);
  server.answer([{}]);
  expect(await answer).toEqual([{}]);
});

it("gives answers that change nothing though somebody types on", async () => {
  const { answer } = await asking("textDocument/completion");
  edit();
  server.answer([{}]);
  expect(await answer).toEqual([{}]);
});

it.each(["textDocument/formatting", "textDocument/definition"])("drops the answer to %s of a program that has left the bench", async (method) => {
  const { answer } = await asking(method);
  client.files.put([{ path: "a.bhdl", text: "another" }]);
  server.answer([{}]);
  expect(await answer).toBeNull();
});

it("gives no two texts of a file the same version, though it leaves the bench between them", async () => {
  client.files.put([]);
  client.files.put([{ path: "a.bhdl", text: "another" }]);
  edit();
  await Promise.resolve();
  expect(new Set(server.versions).size).toBe(3);
});

class MuteServer extends SlowServer {
  override send(): void {}
}

it("leaves no rejection to nobody where the server never answers, and where the editor closes before it does", async () => {
  const left: unknown[] = [];
  const note = (reason: unknown) => left.push(reason);
  process.on("unhandledRejection", note);
  vi.useFakeTimers();
  for (const closes of [false, true]) {
    const mute = new BenchClient({ display: () => Promise.resolve(null), edited: () => {} }, {});
    mute.files.put([{ path: "a.bhdl", text: "a" }]);
    mute.connect(new MuteServer()).initializing.catch(() => {});
    mute.files.put([{ path: "b.bhdl", text: "b" }]);
    if (closes) mute.disconnect();
    await vi.advanceTimersByTimeAsync(10_000);
  }
  vi.useRealTimers();
  await new Promise(setImmediate);
  process.off("unhandledRejection", note);
  expect(left).toEqual([]);
});

/** A server that takes its time to begin. */
class StartingServer extends SlowServer {
  #held: string[] = [];
  #isUp = false;
  override send(text: string): void {
    if (this.#isUp) super.send(text);
    else this.#held.push(text);
  }
  begin(): void {
    this.#isUp = true;
    this.#held.splice(0).forEach((text) => super.send(text));
  }
}

it("is connected when the server answers at last, however late, and asks no question for longer than three seconds", async () => {
  vi.useFakeTimers();
  const starting = new StartingServer();
  const late = new BenchClient({ display: () => Promise.resolve(null), edited: () => {} }, {});
  late.files.put([{ path: "a.bhdl", text: "a" }]);
  let isReady = false;
  late.connect(starting).initializing.then(() => (isReady = true), () => {});
  const early = late.request("textDocument/completion", asked).catch((error: Error) => error.message);
  await vi.advanceTimersByTimeAsync(20_000);
  expect(await early).toBe("the language server did not answer in time");
  starting.begin();
  await vi.advanceTimersByTimeAsync(0);
  expect([isReady, starting.versions.length]).toEqual([true, 1]);
  const unanswered = late.request("textDocument/completion", asked).catch((error: Error) => error.message);
  await vi.advanceTimersByTimeAsync(3001);
  expect(await unanswered).toBe("the language server did not answer in time");
  const answered = late.request("textDocument/completion", asked);
  await vi.advanceTimersByTimeAsync(0);
  starting.answer([{}]);
  expect(await answered).toEqual([{}]);
  vi.useRealTimers();
});

it("tells a server what was told before it had answered, in order", async () => {
  client.disconnect();
  const next = new SlowServer();
  const ready = client.connect(next).initializing;
  edit();
  client.sync();
  await ready;
  await Promise.resolve();
  expect(next.versions).toEqual([...next.versions].sort((a, b) => a - b));
  expect(next.versions.length).toBeGreaterThan(0);
});
