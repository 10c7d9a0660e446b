// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Lease } from "../../src/model/lease";
import { Leases } from "../../src/model/leases.svelte";
import { emptyTeam } from "../../src/model/model";

const monitor = vi.hoisted(() => ({ told: [] as unknown[][] }));
const shown = vi.hoisted(() => ({ live: undefined as unknown as { present: unknown; trouble: string | undefined; playback: unknown } }));
vi.mock("../../src/feed/api", () => ({
  changeLease: (...words: unknown[]) => (monitor.told.push(words), Promise.resolve({})),
  status: () => Promise.resolve({ operator: { name: "ada", account: "operator" } }),
}));
vi.mock("../../src/model/live.svelte", () => {
  shown.live = { present: undefined, trouble: undefined, playback: undefined };
  return { live: shown.live };
});

const ada = { name: "ada", account: "operator" };
const ben = { name: "ben", account: "operator" };
const lease = (holder = ada, asker: typeof ada | null = null): Lease => ({ robot: "io", holder, asker, answer_within_s: asker && 7 });

/** What leases there are is fixed before the object is made: nothing here is drawn, so that nothing hears of changes. */
function leasesOf(all: readonly Lease[], me = ada): Leases {
  shown.live.present = { ...emptyTeam, leases: all };
  const leases = new Leases();
  leases.told(me);
  return leases;
}

beforeEach(() => {
  monitor.told = [];
  shown.live.trouble = undefined;
});

describe("one operator alone", () => {
  it("is shown nothing, and says that it is there while it steers", () => {
    const leases = leasesOf([lease()]);
    expect([leases.hasOthers, leases.needsBeat, leases.asked.length]).toEqual([false, true, 0]);
    expect(leasesOf([]).needsBeat).toBe(false);
  });
});

describe("of two operators", () => {
  it("the holder is told who asks, and gives or refuses", () => {
    const leases = leasesOf([lease(ada, ben)]);
    expect(leases.asked.map(({ asker }) => asker?.name)).toEqual(["ben"]);
    leases.give("io");
    leases.refuse("io");
    expect(monitor.told.map(([deed, robots]) => [deed, robots])).toEqual([["give", ["io"]], ["refuse", ["io"]]]);
  });
  it("the other asks, or takes it over with a reason", () => {
    const leases = leasesOf([lease(ada)], ben);
    expect([leases.hasOthers, leases.needsBeat]).toEqual([true, false]);
    leases.ask("io");
    leases.take("io", "it stands in the door");
    expect(monitor.told).toEqual([["ask", ["io"], undefined], ["take", ["io"], "it stands in the door"]]);
  });
  it("who waits says that it is there", () => {
    const leases = leasesOf([lease(ada, ben)], ben);
    expect([leases.needsBeat, leases.asks(leases.of("io")!), leases.isMine(leases.of("io")!)]).toEqual([true, true, false]);
  });
});
