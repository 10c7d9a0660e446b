// SPDX-License-Identifier: BSD-3-Clause
import { LSPClient, type Transport } from "@codemirror/lsp-client";
import { expect, it } from "vitest";
import { BenchWorkspace, pathOf, uriOf } from "../../../src/program/editor/bench_workspace";

interface Message {
  id?: number;
  method: string;
  params: { textDocument?: { uri: string; version: number; text: string }; contentChanges?: { text: string }[] };
}

/** A server that answers `initialize` and keeps the rest. */
class Heard implements Transport {
  messages: Message[] = [];
  #handle: (message: string) => void = () => {};
  send(text: string): void {
    const message = JSON.parse(text) as Message;
    if (message.id === undefined) this.messages.push(message);
    else this.#handle(JSON.stringify({ jsonrpc: "2.0", id: message.id, result: { capabilities: { textDocumentSync: 2 } } }));
  }
  subscribe(handler: (message: string) => void): void {
    this.#handle = handler;
  }
  unsubscribe(): void {}
}

async function benchWith(files: { path: string; text: string }[]) {
  const edited: string[] = [];
  let workspace!: BenchWorkspace;
  const bench = { display: () => Promise.resolve(null), edited: (path: string, text: string) => edited.push(`${path}: ${text}`) };
  const client = new LSPClient({ workspace: (made) => (workspace = new BenchWorkspace(made, { ...bench, edited: (p, t) => void bench.edited(p, t) })) });
  workspace.put(files);
  const heard = new Heard();
  await client.connect(heard).initializing;
  const told = async () => {
    await Promise.resolve();
    return heard.messages.splice(0).filter(({ method }) => method !== "initialized")
      .map(({ method, params }) => `${method.replace("textDocument/", "")} ${params.textDocument?.uri} ${params.textDocument?.text ?? params.contentChanges?.[0]?.text ?? ""}`);
  };
  await told();
  return { workspace, edited, told };
}

it("opens every file on the bench, closes those that leave it and tells what others become", async () => {
  const { workspace, told } = await benchWith([{ path: "a.bhdl", text: "a" }]);
  workspace.put([{ path: "a.bhdl", text: "aa" }, { path: "dir/b c.bhdl", text: "b" }]);
  expect(await told()).toEqual(["didOpen file:///dir/b%20c.bhdl b", "didChange file:///a.bhdl aa"]);
  workspace.put([{ path: "dir/b c.bhdl", text: "b" }]);
  expect(await told()).toEqual(["didClose file:///a.bhdl "]);
});

it("changes files that are in no editor, and says so to the bench and to the server", async () => {
  const { workspace, edited, told } = await benchWith([{ path: "a.bhdl", text: "go on" }]);
  workspace.updateFile("file:///a.bhdl", { changes: { from: 0, to: 2, insert: "move" } });
  workspace.updateFile("file:///a.bhdl", { changes: { from: 0, to: 0, insert: "; " } });
  expect(edited.at(-1)).toBe("a.bhdl: ; move on");
  expect((await told()).at(-1)).toBe("didChange file:///a.bhdl ; move on");
  expect(workspace.isNewest("file:///a.bhdl", 0)).toBe(false);
  expect(workspace.isNewest("file:///a.bhdl", 2)).toBe(true);
});

it("knows a file by its path", () => {
  expect(uriOf("dir/b c.bhdl")).toBe("file:///dir/b%20c.bhdl");
  expect(pathOf("file:///dir/b%20c.bhdl")).toBe("dir/b c.bhdl");
});
