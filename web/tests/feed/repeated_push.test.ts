// SPDX-License-Identifier: BSD-3-Clause
import { afterEach, beforeEach, expect, it, vi } from "vitest";

vi.stubGlobal("location", { hash: "", pathname: "/", search: "" });
vi.stubGlobal("sessionStorage", { getItem: () => null });
const fetched = vi.fn<(path: string, request: RequestInit) => Promise<Response>>();
vi.stubGlobal("fetch", fetched);

const lost = (): Promise<Response> => Promise.reject(new TypeError("Failed to fetch"));
const bodies = (): { id: string }[] => fetched.mock.calls.map(([, { body }]) => JSON.parse(body as string) as { id: string });

/** Lets half a minute pass, with pauses in which answers come. */
async function pass(): Promise<void> {
  for (let second = 0; second < 30; second += 1) await vi.advanceTimersByTimeAsync(1000);
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => {
  vi.useRealTimers();
  fetched.mockReset();
});

it("a push whose answer was lost is sent again with the same id, until it is answered", async () => {
  const api = await import("../../src/feed/api");
  const busy = async (): Promise<Response> => Response.json({ detail: "It is only beginning." }, { status: 503 });
  fetched.mockImplementationOnce(lost).mockImplementationOnce(busy).mockImplementation(async () => Response.json({ id: "1", state: "done" }));
  const pushed = api.push([], ["io"]);
  await pass();
  expect((await pushed).state).toBe("done");
  const ids = bodies().map(({ id }) => id);
  expect(ids).toHaveLength(3);
  expect(new Set(ids).size).toBe(1);
  expect(ids[0]).toMatch(/^[0-9a-f]{16}$/);
});

it("a push that the monitor cannot carry out is not sent again", async () => {
  const api = await import("../../src/feed/api");
  fetched.mockImplementation(async () => Response.json({ detail: "The disk is full." }, { status: 503 }));
  await expect(api.push([], ["io"])).rejects.toThrow("The disk is full.");
  expect(fetched).toHaveBeenCalledTimes(1);
});

it("each push has an id of its own, and what the monitor refuses is not sent again", async () => {
  const api = await import("../../src/feed/api");
  fetched.mockImplementation(async () => Response.json({ detail: "io runs another program." }, { status: 409 }));
  await expect(api.push([], ["io"])).rejects.toThrow("io runs another program.");
  await expect(api.push([], ["io"])).rejects.toThrow("io runs another program.");
  expect(new Set(bodies().map(({ id }) => id)).size).toBe(2);
  expect(fetched).toHaveBeenCalledTimes(2);
});

it("a push that nobody answers ends, and says that it is not known what became of it", async () => {
  const api = await import("../../src/feed/api");
  fetched.mockImplementation(lost);
  const pushed = expect(api.push([], ["io"])).rejects.toThrow("Whether the program was pushed is not known");
  await pass();
  await pushed;
  expect(fetched).toHaveBeenCalledTimes(11);
});

it("what may not be sent twice is not", async () => {
  const api = await import("../../src/feed/api");
  fetched.mockImplementation(lost);
  await expect(api.command("resume", ["io"])).rejects.toThrow("The monitor does not answer.");
  expect(fetched).toHaveBeenCalledTimes(1);
});
