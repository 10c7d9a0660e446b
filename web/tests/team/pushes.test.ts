import { describe, expect, it } from "vitest";
import type { Diagnostic, ProgramReply } from "../../src/feed/messages";
import { T0_MS, told } from "./told";

const push = {
  stamp: { sec: 0, nsec: 0 }, id: "p1", author: "operator", targets: [], replaces_hash: "", hash: "bbbb",
  files: [{ path: "programs/sit_and_spin.bhdl", text: "" }],
};
function reply(robot: string, status: number, diagnostics: Diagnostic[] = []): ProgramReply {
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
  it("does not fall back when an earlier answer comes late", () => {
    const team = told([
      ["/team/program_push", push, T0_MS],
      ["/io/program_reply", reply("io", 4), T0_MS + 50],
      ["/io/program_reply", reply("io", 1), T0_MS + 60],
    ]);
    expect(team.pushes[0]?.replies.get("io")?.status).toBe("confirmed");
  });
});
