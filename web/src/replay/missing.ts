// SPDX-License-Identifier: BSD-3-Clause
import { listRecordings } from "../feed/api";
import { live } from "../model/live.svelte";

/** What a reader of the page can do, and one of the wall, who has nothing to press. */
export const CHOOSE = "choose another one under “Recordings”";
export const NAME_ANOTHER = "name another one in the address";

/** Why the monitor does not play a recording, and what to do, in one sentence; undefined: nothing is wrong with the recording. */
async function whyMissing(name: string, instead: string): Promise<string | undefined> {
  const { recordings, folder } = await listRecordings();
  const found = recordings.find((each) => each.name === name);
  if (!found) return `There is no recording ${name} at this monitor: ${instead}, or put it into ${folder}.`;
  return found.why && `${name} cannot be opened: ${found.why}`;
}

/** Called where a recording was not opened: if something is wrong with it, that is told, and it is asked for no more. */
export async function giveUpMissing(name: string, instead: string): Promise<void> {
  const why = await whyMissing(name, instead);
  if (why) live.giveUp(why);
}
