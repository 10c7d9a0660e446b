// SPDX-License-Identifier: BSD-3-Clause
import { listRecordings } from "../feed/api";

/** Why the monitor does not play a recording, and what to do, in one sentence; undefined: nothing is wrong with the recording. */
export async function whyMissing(name: string): Promise<string | undefined> {
  const { recordings, folder } = await listRecordings();
  const found = recordings.find((each) => each.name === name);
  if (!found) return `There is no recording ${name} at this monitor: choose another one under “Recordings”, or put it into ${folder}.`;
  return found.why && `${name} cannot be opened: ${found.why}`;
}
