// SPDX-License-Identifier: BSD-3-Clause
// The monitor's language server, as the editor uses it: completion, hover, definition, rename,
// layout and problems as one types. Without it the editor still edits.

import {
  findReferencesKeymap, formatKeymap, hoverTooltips, jumpToDefinitionKeymap, renameKeymap, serverCompletion,
  serverDiagnostics, type Transport,
} from "@codemirror/lsp-client";
import type { Extension } from "@codemirror/state";
import { keymap } from "@codemirror/view";
import type { SourceFile } from "../../feed/messages";
import { BenchClient } from "./bench_client";
import { type Bench, pathOf, uriOf } from "./bench_workspace";
import { harmless } from "./harmless_html";
import { problemsFrom, type PublishedProblems } from "./problems";
import { type CodeAction, type FixableDiagnostic, withFixes } from "./quick_fixes";
import { withToken } from "../../feed/token";

export interface LanguageEvents extends Bench {
  /** What is wrong with a file, as of its newest text. */
  problems(path: string, problems: FixableDiagnostic[]): void;
  /** There is no server any more; what it said of problems is out of date. */
  lost(): void;
}

/** One socket; what is sent before it is open waits. */
class SocketTransport implements Transport {
  #socket: WebSocket;
  #waiting: string[] = [];
  #handlers = new Set<(message: string) => void>();

  constructor(url: string, ended: () => void) {
    this.#socket = new WebSocket(url);
    this.#socket.onopen = () => this.#waiting.splice(0).forEach((message) => this.#socket.send(message));
    this.#socket.onmessage = ({ data }) => this.#handlers.forEach((handle) => handle(String(data)));
    this.#socket.onclose = ended;
  }
  send(message: string): void {
    if (this.#socket.readyState === WebSocket.CONNECTING) this.#waiting.push(message);
    else this.#socket.send(message);
  }
  subscribe(handler: (message: string) => void): void {
    this.#handlers.add(handler);
  }
  unsubscribe(handler: (message: string) => void): void {
    this.#handlers.delete(handler);
  }
  close(): void {
    this.#socket.onclose = null;
    this.#socket.close();
  }
}

export class LanguageServer {
  #client: BenchClient;
  #transport: SocketTransport | undefined;

  constructor(events: LanguageEvents) {
    this.#client = new BenchClient(events, {
      rootUri: uriOf(""),
      sanitizeHTML: harmless,
      notificationHandlers: {
        "textDocument/publishDiagnostics": (_, params: PublishedProblems) => {
          if (this.#client.files.isNewest(params.uri, params.version)) void this.#tell(params, events);
          return true;
        },
      },
      extensions: [
        serverCompletion(), hoverTooltips(), serverDiagnostics(),
        keymap.of([...formatKeymap, ...renameKeymap, ...jumpToDefinitionKeymap, ...findReferencesKeymap]),
      ],
    });
    this.#lost = () => {
      this.#client.disconnect();
      this.#transport = undefined;
      events.lost();
    };
  }
  #lost: () => void;

  /** The problems at once, and again with what would put them right. */
  async #tell(params: PublishedProblems, events: LanguageEvents): Promise<void> {
    const { uri, version, diagnostics } = params;
    const path = pathOf(uri);
    const problems = problemsFrom(path, params);
    events.problems(path, problems);
    if (diagnostics.length === 0) return;
    const range = { start: { line: 0, character: 0 }, end: { line: 2 ** 31 - 1, character: 0 } };
    const context = { diagnostics: [], only: ["quickfix"] };
    const ask = this.#client.request<object, CodeAction[] | null>("textDocument/codeAction", { textDocument: { uri }, range, context });
    const actions = await ask.catch(() => null); // without them the problems still stand
    const text = this.#client.files.getFile(uri)?.doc.toString();
    if (actions?.length && text !== undefined && this.#client.files.isNewest(uri, version)) events.problems(path, withFixes(problems, actions, text));
  }

  /** Does nothing while connected. `robot`: whose catalog programs are checked against. */
  connect(origin: string, robot?: string): void {
    if (this.#transport) return;
    const query = robot === undefined ? "" : `?robot=${encodeURIComponent(robot)}`;
    this.#transport = new SocketTransport(withToken(`${origin}/lsp${query}`), this.#lost);
    // Where there is no server, the editor goes on without.
    this.#client.connect(this.#transport).initializing.catch(() => {});
  }

  /** Shows the server which files there are, and what they hold. */
  put(files: readonly SourceFile[]): void {
    this.#client.files.put(files);
  }

  /** What an editor of this file takes to be served. */
  extension(path: string): Extension {
    return this.#client.plugin(uriOf(path), "bhdl");
  }

  close(): void {
    this.#transport?.close();
    if (this.#transport) this.#client.disconnect();
    this.#transport = undefined;
  }
}
