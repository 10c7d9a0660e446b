// SPDX-License-Identifier: BSD-3-Clause
import { Refusal } from "./api";
import { credentials } from "./token";

/** What the monitor says of why it does not take a file; undefined: it says nothing that can be shown. */
function detailIn(text: string): string | undefined {
  try {
    const { detail, title } = JSON.parse(text) as { detail?: string; title?: string };
    return detail || title;
  } catch {
    return undefined;
  }
}

/** What the monitor says of a recording that it has kept. */
function noteIn(text: string): string | undefined {
  try {
    return (JSON.parse(text) as { note?: string }).note || undefined;
  } catch {
    return undefined;
  }
}

function sentenceOf(name: string, { status, responseText }: XMLHttpRequest): string {
  const known: Record<number, string> = {
    404: "This monitor takes no recordings: update it, or copy the file into its folder.",
    405: "This monitor takes no recordings: update it, or copy the file into its folder.",
    409: `The monitor has a recording named ${name} already: open that one, or rename the file and drop it again.`,
    413: `${name} is larger than the monitor takes: copy it into the monitor's folder of recordings.`,
    507: `${name} finds no room on the monitor's disk: make some, then drop the file again.`,
  };
  return detailIn(responseText) ?? known[status] ?? `The monitor did not take ${name} and answered ${status}: see what it printed.`;
}

/**
 * Sends a file to the monitor to be kept as a recording. `told` is told which share of it, 0 to 1, has gone.
 * `fetch` would not say that.
 * Returns a sentence of the monitor on what the recording lacks, if it is kept and not whole.
 * Errors: a Refusal with one sentence that says what to do, also where `signal` ended it.
 */
export function upload(file: Blob, name: string, told: (share: number) => void, signal: AbortSignal): Promise<string | undefined> {
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    const refuse = (sentence: string) => reject(new Refusal(sentence));
    request.open("PUT", `/api/recordings/${encodeURIComponent(name)}`);
    for (const [header, value] of Object.entries(credentials())) request.setRequestHeader(header, value);
    request.setRequestHeader("content-type", "application/octet-stream");
    request.upload.onprogress = ({ loaded, total }) => told(total > 0 ? loaded / total : 0);
    request.onload = () => (request.status >= 200 && request.status < 300 ? resolve(noteIn(request.responseText)) : refuse(sentenceOf(name, request)));
    request.onerror = () => refuse(`Sending ${name} broke off: see whether the monitor still runs and has room on its disk, then drop the file again.`);
    request.onabort = () => refuse(`Sending ${name} was cancelled: nothing of it was kept.`);
    signal.addEventListener("abort", () => request.abort());
    request.send(file);
  });
}
