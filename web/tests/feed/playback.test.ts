// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { isStateFrame, requestFrame, stateOf } from "../../src/feed/playback";

const bytes = (frame: Uint8Array) => [...frame].map((each) => each.toString(16).padStart(2, "0")).join(" ");
/** As Foxglove's specification lays it out. */
const frameOf = (text: string) => new Uint8Array(text.split(" ").map((each) => Number.parseInt(each, 16))).buffer;

describe("a request to play", () => {
  it("is opcode 3, play, speed, no seek, and the id with its length", () => {
    expect(bytes(requestFrame({ plays: true, speed: 1, id: "page 1" }))).toBe("03 00 00 00 80 3f 00 00 00 00 00 00 00 00 00 06 00 00 00 70 61 67 65 20 31");
  });
  it("carries where to pause and go to, to the nanosecond", () => {
    expect(bytes(requestFrame({ plays: false, speed: 0.5, seek_ns: 1_732_795_200_100_000_001n, id: "ü" }))).toBe("03 01 00 00 00 3f 01 01 61 76 c2 0d 20 0c 18 02 00 00 00 c3 bc");
  });
});

describe("the state of a playback", () => {
  const playing = frameOf("05 00 00 00 00 00 00 00 00 01 00 00 00 40 01 02 00 00 00 69 64");
  it("is opcode 5, and no other frame is taken for it", () => {
    expect(isStateFrame(playing)).toBe(true);
    expect(isStateFrame(frameOf("02 00 00 00 00 00 00 00 00"))).toBe(false);
    expect(isStateFrame(new ArrayBuffer(0))).toBe(false);
  });
  it("tells status, time, speed, whether it sought, and what it answers", () => {
    expect(stateOf(playing)).toEqual({ status: "playing", now_ns: 1n << 56n, speed: 2, sought: true, id: "id" });
    expect(stateOf(frameOf("05 03 00 00 00 00 00 00 00 00 00 00 80 3f 00 00 00 00 00"))).toEqual({ status: "ended", now_ns: 0n, speed: 1, sought: false, id: "" });
  });
  it("is nothing where it is cut, or says what there is not", () => {
    expect(stateOf(playing.slice(0, 18))).toBeUndefined();
    expect(stateOf(playing.slice(0, 20))).toBeUndefined();
    expect(stateOf(frameOf("05 04 00 00 00 00 00 00 00 00 00 00 80 3f 00 00 00 00 00"))).toBeUndefined();
  });
});
