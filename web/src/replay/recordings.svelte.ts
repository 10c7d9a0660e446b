// SPDX-License-Identifier: BSD-3-Clause
// The recordings that the monitor has, and the one that is on its way to it.

import { listRecordings, type Recording } from "../feed/api";
import { shownAt } from "../feed/recording";
import { upload } from "../feed/upload";
import { Attempts } from "../lib/attempts.svelte";
import { Latest } from "../lib/latest";
import { workshop } from "../program/workshop.svelte";

interface Upload {
  readonly name: string;
  /** 0 to 1. */
  readonly share: number;
}

class Recordings {
  readonly listing = new Attempts();
  readonly sending = new Attempts();
  /** Undefined until the monitor has told. */
  all = $state.raw<readonly Recording[]>();
  folder = $state("");
  upload = $state.raw<Upload>();
  /** What came of the last upload, where the page stays. */
  news = $state<string>();
  #lists = new Latest();
  #cancel: AbortController | undefined;

  /** Opening one would lose what somebody edits here: then it is opened in a tab of its own. */
  get opensTab(): boolean {
    return workshop.bench.draft.edited;
  }

  async list(): Promise<void> {
    const sentence = ({ message }: Error) => `The recordings cannot be listed: ${message.replace(/\.$/, "")}; start the monitor, or update it, then list them again.`;
    await this.listing.make(() => this.#lists.take(listRecordings(), ({ folder, recordings }) => ([this.all, this.folder] = [recordings, folder])), sentence);
  }

  /** Sends a file to the monitor, and opens it there, unless the monitor has something to say of it. */
  async take(files: readonly File[]): Promise<void> {
    this.news = undefined;
    await this.sending.make(async () => {
      const file = this.#only(files);
      const note = await this.#send(file);
      if (!note && !this.opensTab) return location.assign(shownAt(file.name));
      this.news = note ?? `${file.name} is at the monitor: open it here.`;
      await this.list();
    });
  }

  cancel(): void {
    this.#cancel?.abort();
  }

  #only(files: readonly File[]): File {
    const [file, ...others] = files;
    if (this.upload) throw new Error(`${this.upload.name} is still on its way: wait for it, or cancel it.`);
    if (!file) throw new Error("What was dropped is no file: drop an .mcap file.");
    if (others.length > 0) throw new Error(`${files.length} files were dropped: drop one recording at a time.`);
    if (!/\.mcap$/i.test(file.name)) throw new Error(`${file.name} is no .mcap file: drop a recording such as run.mcap.`);
    if (file.size === 0) throw new Error(`${file.name} is empty, or a folder: drop an .mcap file.`);
    return file;
  }

  async #send(file: File): Promise<string | undefined> {
    const { name } = file;
    this.#cancel = new AbortController();
    this.upload = { name, share: 0 };
    try {
      return await upload(file, name, (share) => (this.upload = { name, share }), this.#cancel.signal);
    } finally {
      this.upload = undefined;
    }
  }
}

export const recordings = new Recordings();
