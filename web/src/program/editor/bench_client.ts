// SPDX-License-Identifier: BSD-3-Clause
import { LSPClient, type LSPClientConfig } from "@codemirror/lsp-client";
import { type Bench, BenchWorkspace } from "./bench_workspace";

/** Requests whose answers are changes of the text that was asked about. */
const CHANGES = new Set(["textDocument/formatting", "textDocument/rename"]);

/**
 * A client whose answers are of the text that stands on the bench: those to questions of another program come to
 * nothing, and none changes a text that somebody edited since it was asked about.
 */
export class BenchClient extends LSPClient {
  readonly files: BenchWorkspace;

  constructor(bench: Bench, config: LSPClientConfig) {
    super({ ...config, workspace: (client) => new BenchWorkspace(client, bench) });
    this.files = this.workspace as BenchWorkspace;
  }

  /** Errors: the answer would change a text that was edited meanwhile. */
  override async request<Params, Result>(method: string, params: Params): Promise<Result> {
    const { generation, texts } = this.files;
    const answer = await super.request<Params, Result>(method, params);
    if (generation !== this.files.generation) return null as Result; // as a server answers that knows nothing
    const isEdited = [...this.files.texts].some(([uri, text]) => !texts.get(uri)?.eq(text));
    if (isEdited && CHANGES.has(method)) throw new Error("the text was edited meanwhile; ask again");
    return answer;
  }
}
