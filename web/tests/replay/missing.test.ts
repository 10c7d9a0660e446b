// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, expect, it, vi } from "vitest";
import * as api from "../../src/feed/api";
import { live } from "../../src/model/live.svelte";
import { CHOOSE, giveUpMissing, NAME_ANOTHER } from "../../src/replay/missing";

vi.mock("../../src/model/live.svelte", () => ({ live: { giveUp: vi.fn() } }));
vi.mock("../../src/feed/api", () => ({ listRecordings: vi.fn() }));

const given = () => vi.mocked(live.giveUp).mock.calls.flat();

beforeEach(() => {
  const recordings = [{ name: "run.mcap" }, { name: "broken.mcap", why: "Record it anew." }] as api.Recording[];
  vi.mocked(api.listRecordings).mockReset().mockResolvedValue({ folder: "/recordings", recordings });
  vi.mocked(live.giveUp).mockReset();
});

it("a recording that is not there is given up, with what its reader can do there", async () => {
  await giveUpMissing("gone.mcap", CHOOSE);
  await giveUpMissing("gone.mcap", NAME_ANOTHER);
  expect(given()).toEqual([
    "There is no recording gone.mcap at this monitor: choose another one under “Recordings”, or put it into /recordings.",
    "There is no recording gone.mcap at this monitor: name another one in the address, or put it into /recordings.",
  ]);
});

it("one that cannot be opened is given up with the monitor's reason", async () => {
  await giveUpMissing("broken.mcap", NAME_ANOTHER);
  expect(given()).toEqual(["broken.mcap cannot be opened: Record it anew."]);
});

it("one with which nothing is wrong is asked for again, and so is one of which nothing is known", async () => {
  await giveUpMissing("run.mcap", NAME_ANOTHER);
  vi.mocked(api.listRecordings).mockRejectedValue(new Error("The monitor does not answer."));
  await expect(giveUpMissing("gone.mcap", NAME_ANOTHER)).rejects.toThrow();
  expect(given()).toEqual([]);
});
