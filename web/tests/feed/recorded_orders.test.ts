// SPDX-License-Identifier: BSD-3-Clause
import { expect, it, vi } from "vitest";

vi.stubGlobal("location", { hash: "", pathname: "/", search: "?recording=office.mcap" });
vi.stubGlobal("sessionStorage", { getItem: () => null });
const fetched = vi.fn(async (_path: string) => Response.json({ programs: [] }));
vi.stubGlobal("fetch", fetched);

it("a page that shows a recording sends no order, whoever gives it, and asks what it likes", async () => {
  const api = await import("../../src/feed/api");
  const orders = [() => api.command("hold", []), () => api.orderBreaks("clear", []), () => api.push([], []), () => api.cancelPush("1"), () => api.orderSimulation("office", { order: "pause" }), () => api.changeLease("ask", ["io"])];
  for (const order of orders) await expect(order()).rejects.toThrow("a recording cannot be stopped or steered");
  expect(fetched).not.toHaveBeenCalled();
  await api.listPrograms();
  expect(fetched.mock.calls.map(([path]) => path)).toEqual(["/api/programs"]);
});
