// SPDX-License-Identifier: BSD-3-Clause
import { afterEach, expect, it, vi } from "vitest";
import { upload } from "../../src/feed/upload";

/** Answers each request as the monitor would. */
function answering(status: number, responseText: string): void {
  class FakeRequest {
    status = status;
    responseText = responseText;
    upload: { onprogress?: unknown } = {};
    onload = () => {};
    open = () => {};
    setRequestHeader = () => {};
    abort = () => {};
    send = () => this.onload();
  }
  vi.stubGlobal("XMLHttpRequest", FakeRequest);
}

const send = (name: string) => upload(new Blob(["x"]), name, () => {}, new AbortController().signal);

afterEach(() => void vi.unstubAllGlobals());

it("a refusal is told in the monitor's own sentence", async () => {
  answering(422, JSON.stringify({ title: "Unprocessable Entity", detail: "'junk.mcap' is not an MCAP file." }));
  await expect(send("junk.mcap")).rejects.toThrow("'junk.mcap' is not an MCAP file.");
});
it("a refusal without words is told in one that says what to do", async () => {
  answering(409, "");
  await expect(send("run.mcap")).rejects.toThrow("The monitor has a recording named run.mcap already: open that one, or rename the file and drop it again.");
});
it("gives what the monitor says of a recording that is kept and not whole", async () => {
  answering(201, JSON.stringify({ name: "cut.mcap", complete: false, note: "'cut.mcap' is not whole." }));
  expect(await send("cut.mcap")).toBe("'cut.mcap' is not whole.");
  answering(201, JSON.stringify({ name: "run.mcap", complete: true }));
  expect(await send("run.mcap")).toBeUndefined();
});
