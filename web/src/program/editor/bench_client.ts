// SPDX-License-Identifier: BSD-3-Clause
import { LSPClient, type LSPClientConfig, type Transport } from "@codemirror/lsp-client";
import { type Bench, BenchWorkspace } from "./bench_workspace";

/** Requests whose answers are changes of the text that was asked about. */
const CHANGES = new Set(["textDocument/formatting", "textDocument/rename"]);

/** A question that is answered later than this is no longer asked; a server that is starting is waited for. */
const LATE_MS = 3000;
/** The longest that a browser's clock can wait: as long as the connection lasts. */
const NEVER_MS = 2 ** 31 - 1;

function inTime<T>(answer: Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error("the language server did not answer in time")), LATE_MS);
    answer.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}

/**
 * A client whose answers are of the text that stands on the bench: those to questions of another program come to
 * nothing, and none changes a text that somebody edited since it was asked about.
 */
export class BenchClient extends LSPClient {
  readonly files: BenchWorkspace;
  /** Undefined while not connected. */
  #server: Transport | undefined;

  constructor(bench: Bench, config: LSPClientConfig) {
    super({ ...config, timeout: NEVER_MS, workspace: (client) => new BenchWorkspace(client, bench) });
    this.files = this.workspace as BenchWorkspace;
  }

  override connect(server: Transport): this {
    this.#server = server;
    return super.connect(server);
  }

  override disconnect(): void {
    this.#server = undefined;
    super.disconnect();
  }

  /** Where the server never answers, nothing is told and nothing is wrong; the base class would leave a rejection that nobody handles. */
  override notification<Params>(method: string, params: Params): void {
    const server = this.#server;
    if (!server) return;
    const tell = () => server.send(JSON.stringify({ jsonrpc: "2.0", method, params }));
    this.initializing.then(tell, () => {});
  }

  /** Errors: the server does not answer in time, or the answer would change a text that was edited meanwhile. */
  override async request<Params, Result>(method: string, params: Params): Promise<Result> {
    const { generation, texts } = this.files;
    const answer = await inTime(super.request<Params, Result>(method, params));
    if (generation !== this.files.generation) return null as Result; // as a server answers that knows nothing
    const isEdited = [...this.files.texts].some(([uri, text]) => !texts.get(uri)?.eq(text));
    if (isEdited && CHANGES.has(method)) throw new Error("the text was edited meanwhile; ask again");
    return answer;
  }
}
