// SPDX-License-Identifier: BSD-3-Clause
import { LSPClient, LSPPlugin, Workspace, type WorkspaceFile } from "@codemirror/lsp-client";
import { ChangeSet, Text, type TransactionSpec } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";
import type { SourceFile } from "../../feed/messages";

/** Where the files lie that the language server speaks of. */
export interface Bench {
  /** Brings a file into the editor; its view, or null if there is no such file. */
  display(path: string): Promise<EditorView | null>;
  /** The language server changed a file that is not in the editor. */
  edited(path: string, text: string): void;
}

export const uriOf = (path: string): string => `file:///${path.split("/").map(encodeURIComponent).join("/")}`;
export const pathOf = (uri: string): string => decodeURIComponent(uri.replace(/^file:\/\/\//, ""));

class BenchFile implements WorkspaceFile {
  readonly languageId = "bhdl";
  view: EditorView | null = null;
  /** Changes that were made without a view and that the server does not know yet. */
  unsent: ChangeSet | undefined;

  constructor(
    readonly uri: string,
    public version: number,
    public doc: Text,
  ) {}
  getView(): EditorView | null {
    return this.view;
  }
  get text(): Text {
    return this.unsent ? this.unsent.apply(this.doc) : this.doc;
  }
}

const textOf = (text: string): Text => Text.of(text.split(/\r\n?|\n/));

/** Every file on the bench is open at the server; at most one of them has an editor. */
export class BenchWorkspace extends Workspace {
  files: BenchFile[] = [];
  /** Grows with each program that comes onto the bench. */
  generation = 0;
  /** No two texts of a file have one version, even where it leaves the bench between them. */
  #version = 0;

  constructor(
    client: LSPClient,
    private readonly bench: Bench,
  ) {
    super(client);
  }

  /** The text of each file, as it is edited, by the file's URI. */
  get texts(): ReadonlyMap<string, Text> {
    return new Map(this.files.map((file) => [file.uri, file.view?.state.doc ?? file.text]));
  }

  put(files: readonly SourceFile[]): void {
    this.generation += 1;
    const wanted = new Map(files.map(({ path, text }) => [uriOf(path), text]));
    for (const file of this.files.filter(({ uri }) => !wanted.has(uri))) this.#drop(file);
    for (const [uri, text] of wanted) this.#take(uri, textOf(text));
    this.client.sync();
  }

  isNewest(uri: string, version: number | undefined): boolean {
    const file = this.getFile(uri);
    return file !== null && (version === undefined || version === file.version);
  }

  override getFile(uri: string): BenchFile | null {
    return this.files.find((file) => file.uri === uri) ?? null;
  }

  syncFiles() {
    return this.files.flatMap((file) => {
      const plugin = file.view && LSPPlugin.get(file.view);
      const changes = plugin ? plugin.unsyncedChanges : file.unsent;
      if (!changes || changes.empty) return [];
      const prevDoc = file.doc;
      file.doc = plugin ? plugin.view.state.doc : changes.apply(prevDoc);
      file.version = this.#version++;
      file.unsent = undefined;
      plugin?.clear();
      return [{ file, prevDoc, changes }];
    });
  }

  openFile(uri: string, _language: string, view: EditorView): void {
    this.#take(uri, view.state.doc);
    this.client.sync();
    const file = this.getFile(uri);
    if (file) file.view = view;
  }

  closeFile(uri: string, view: EditorView): void {
    const file = this.getFile(uri);
    if (!file || file.view !== view) return;
    file.view = null;
    this.#take(uri, view.state.doc);
    this.client.sync();
  }

  override updateFile(uri: string, update: TransactionSpec): void {
    const file = this.getFile(uri);
    if (!file) return;
    if (file.view) return file.view.dispatch(update);
    const more = ChangeSet.of(update.changes ?? [], file.text.length);
    file.unsent = file.unsent ? file.unsent.compose(more) : more;
    this.bench.edited(pathOf(uri), file.text.toString());
    this.client.sync();
  }

  override displayFile(uri: string): Promise<EditorView | null> {
    return this.bench.display(pathOf(uri));
  }

  #take(uri: string, text: Text): void {
    const file = this.getFile(uri);
    if (!file) {
      const opened = new BenchFile(uri, this.#version++, text);
      this.files.push(opened);
      this.client.didOpen(opened);
    } else if (!file.view && !file.text.eq(text)) {
      const whole = ChangeSet.of({ from: 0, to: file.text.length, insert: text }, file.text.length);
      file.unsent = file.unsent ? file.unsent.compose(whole) : whole;
    }
  }

  #drop(file: BenchFile): void {
    this.files = this.files.filter((each) => each !== file);
    this.client.didClose(file.uri);
  }
}
