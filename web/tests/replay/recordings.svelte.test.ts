// SPDX-License-Identifier: BSD-3-Clause
import { File as NodeFile } from "node:buffer";
import { beforeEach, describe, expect, it, vi } from "vitest";
import * as api from "../../src/feed/api";
import { upload } from "../../src/feed/upload";
import { workshop } from "../../src/program/workshop.svelte";
import { recordings } from "../../src/replay/recordings.svelte";

vi.mock("../../src/model/live.svelte", () => import("../fixture/fake_live.svelte"));
vi.mock("../../src/lib/ui.svelte", () => ({ ui: {} }));
vi.mock("../../src/feed/upload", () => ({ upload: vi.fn() }));
vi.mock("../../src/feed/api", () => ({ listRecordings: vi.fn(), Refusal: Error }));

const assign = vi.fn();
vi.stubGlobal("location", { assign });
/** Node 18 has it in a module. */
const file = (name: string, content = "what was recorded") => new NodeFile([content], name) as unknown as File;

beforeEach(() => {
  vi.mocked(upload).mockReset().mockResolvedValue(undefined);
  vi.mocked(api.listRecordings).mockReset().mockResolvedValue({ folder: "/recordings", recordings: [] });
  assign.mockReset();
  workshop.bench.put({ chosen: "", files: [{ path: "a.bhdl", text: "a" }], edited: false });
});

describe("a file that is dropped", () => {
  it("goes to the monitor, and is opened then", async () => {
    vi.mocked(upload).mockImplementation(async (_file, _name, told) => {
      told(0.5);
      expect(recordings.upload).toEqual({ name: "my run.mcap", share: 0.5 });
      expect(assign).not.toHaveBeenCalled();
      return undefined;
    });
    await recordings.take([file("my run.mcap")]);
    expect(assign).toHaveBeenCalledWith("/?recording=my%20run.mcap");
    expect(recordings.upload).toBeUndefined();
  });
  it("is not opened over a program that is edited", async () => {
    workshop.bench.edit("a.bhdl", "b");
    await recordings.take([file("run.mcap")]);
    expect(assign).not.toHaveBeenCalled();
    expect(recordings.news).toBe("run.mcap is at the monitor: open it here.");
    expect(recordings.all).toEqual([]);
  });
  it("that is not whole is said to be so before it is opened", async () => {
    vi.mocked(upload).mockResolvedValue("'cut.mcap' was kept, but is not whole.");
    await recordings.take([file("cut.mcap")]);
    expect(assign).not.toHaveBeenCalled();
    expect(recordings.news).toBe("'cut.mcap' was kept, but is not whole.");
  });
  it("that is none, or another, is refused in a sentence that says what to do", async () => {
    const refusals: (string | undefined)[] = [];
    for (const files of [[], [file("a.mcap"), file("b.mcap")], [file("notes.txt")], [file("empty.mcap", "")]]) {
      await recordings.take(files);
      refusals.push(recordings.sending.failure);
    }
    expect(refusals).toEqual([
      "What was dropped is no file: drop an .mcap file.",
      "2 files were dropped: drop one recording at a time.",
      "notes.txt is no .mcap file: drop a recording such as run.mcap.",
      "empty.mcap is empty, or a folder: drop an .mcap file.",
    ]);
    expect(upload).not.toHaveBeenCalled();
  });
  it("that was refused is told of while the list comes, too", async () => {
    const listed = recordings.list();
    await recordings.take([file("notes.txt")]);
    await listed;
    await recordings.list();
    expect(recordings.sending.failure).toMatch(/^notes\.txt is no \.mcap file/);
  });
  it("waits for the one before", async () => {
    let end = () => {};
    vi.mocked(upload).mockImplementation(() => new Promise((resolve) => (end = () => resolve(undefined))));
    const first = recordings.take([file("first.mcap")]);
    await recordings.take([file("second.mcap")]);
    expect(recordings.sending.failure).toBe("first.mcap is still on its way: wait for it, or cancel it.");
    end();
    await first;
    expect(assign.mock.calls).toEqual([["/?recording=first.mcap"]]);
  });
  it("that the monitor refuses is told of in its words, and nothing is opened", async () => {
    vi.mocked(upload).mockRejectedValue(new Error("There is no room: make some."));
    await recordings.take([file("run.mcap")]);
    expect(recordings.sending.failure).toBe("There is no room: make some.");
    expect([recordings.upload, assign.mock.calls]).toEqual([undefined, []]);
  });
});

it("a list that does not come says what to do", async () => {
  vi.mocked(api.listRecordings).mockRejectedValue(new Error("The monitor does not answer."));
  await recordings.list();
  expect(recordings.listing.failure).toBe("The recordings cannot be listed: The monitor does not answer; start the monitor, or update it, then list them again.");
});
