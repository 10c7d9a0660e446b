// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import type { Diagnostic, ProgramReply } from "../../src/feed/messages";
import { withInterrupted } from "../../src/model/pushes";
import { T0_MS, told } from "./told";

const push = {
  stamp: { sec: 0, nsec: 0 }, id: "p1", author: "operator", targets: [], replaces_hash: "", hash: "bbbb",
  files: [{ path: "programs/sit_and_spin.bhdl", text: "" }],
};
function reply(robot: string, status: ProgramReply["status"], diagnostics: Diagnostic[] = []): ProgramReply {
  return { stamp: { sec: 0, nsec: 0 }, id: "p1", robot, hash: "bbbb", running_hash: "", status, message: "", tick: 0n, swap_tick_us: 8, kept_variables: [], diagnostics };
}

describe("a push", () => {
  it("shows each robot's newest answer", () => {
    const team = told([
      ["/team/program_push", push, T0_MS],
      ["/io/program_reply", reply("io", 3), T0_MS + 50],
      ["/ganymede/program_reply", reply("ganymede", 2, [{ file: "a", line: 3, column: 1, severity: "error", code: "", message: "no", hint: "" }]), T0_MS + 50],
      ["/io/program_reply", reply("io", 4), T0_MS + 5000],
    ]);
    const [only] = team.pushes;
    expect(only?.name).toBe("sit_and_spin.bhdl");
    expect(only?.replies.get("io")?.status).toBe("confirmed");
    expect(only?.replies.get("ganymede")).toMatchObject({ status: "rejected", diagnostics: [{ line: 3 }] });
  });
  it("stays itself among others, and keeps its time and answers when it is told again", () => {
    const other = { ...push, id: "p2", files: [{ path: "a/b/wander.bhdl", text: "" }] };
    const team = told([
      ["/team/program_push", push, T0_MS],
      ["/team/program_push", other, T0_MS + 10],
      ["/io/program_reply", reply("io", 4), T0_MS + 50],
      ["/team/program_push", push, T0_MS + 90],
    ]);
    expect(team.pushes.map(({ id, name, at_ms }) => [id, name, at_ms])).toEqual([["p2", "wander.bhdl", T0_MS + 10], ["p1", "sit_and_spin.bhdl", T0_MS]]);
    expect(team.pushes.map(({ replies }) => [...replies.keys()])).toEqual([[], ["io"]]);
  });
  it("is kept until eight newer ones came", () => {
    const many = Array.from({ length: 10 }, (_, i): [string, unknown, number] => ["/team/program_push", { ...push, id: `p${i}` }, T0_MS + i]);
    expect(told(many).pushes.map(({ id }) => id)).toEqual(["p2", "p3", "p4", "p5", "p6", "p7", "p8", "p9"]);
  });
  it("does not fall back when an earlier answer comes late", () => {
    const team = told([
      ["/team/program_push", push, T0_MS],
      ["/io/program_reply", reply("io", 4), T0_MS + 50],
      ["/io/program_reply", reply("io", 1), T0_MS + 60],
    ]);
    expect(team.pushes[0]?.replies.get("io")?.status).toBe("confirmed");
  });
  it("shows its steps before any robot was sent it, and stays over once it is", () => {
    const progress = (state: string, canary: string) => ({
      stamp: { sec: 0, nsec: 0 }, id: "p1", author: "balch", program: "sit_and_spin.bhdl", hash: "bbbb", targets: [], state,
      steps: [{ name: "check", state: "done", detail: "" }, { name: "canary", state: canary, detail: "io runs it" }],
    });
    const team = told([
      ["/team/push_progress", progress("running", "running"), T0_MS],
      ["/team/program_push", push, T0_MS + 10],
      ["/team/push_progress", progress("failed", "failed"), T0_MS + 20],
      ["/team/push_progress", progress("running", "running"), T0_MS + 30],
    ]);
    expect(team.pushes).toHaveLength(1);
    expect(team.pushes[0]).toMatchObject({ state: "failed", name: "sit_and_spin.bhdl" });
    expect(team.pushes[0]?.steps[1]?.state).toBe("failed");
  });
  it("that failed is confirmed when its robots tell later that they run it", () => {
    const progress = (state: string) => ({ stamp: { sec: 0, nsec: 0 }, id: "p1", author: "balch", program: "a.bhdl", hash: "bbbb", targets: [], state, steps: [] });
    const states = ["running", "failed", "told_later", "running"].map((state, i): [string, unknown, number] => ["/team/push_progress", progress(state), T0_MS + i]);
    expect(told(states.slice(0, 2)).pushes[0]?.state).toBe("failed");
    expect(told(states).pushes[0]?.state).toBe("told_later");
  });
  it("is interrupted on a new connection, until the monitor says again that it runs", () => {
    const progress = (state: string) => ({ stamp: { sec: 0, nsec: 0 }, id: "p1", author: "balch", program: "a.bhdl", hash: "bbbb", targets: [], state, steps: [] });
    const before = told([["/team/push_progress", progress("running"), T0_MS]]);
    const after = { ...before, pushes: withInterrupted(before.pushes) };
    expect(after.pushes[0]?.state).toBe("interrupted");
    expect(told([["/team/push_progress", progress("running"), T0_MS + 10]], after).pushes[0]?.state).toBe("running");
    expect(withInterrupted(told([["/team/push_progress", progress("done"), T0_MS]]).pushes)[0]?.state).toBe("done");
  });
});
