// SPDX-License-Identifier: BSD-3-Clause
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import type { Program } from "../../src/feed/messages";
import { cameraOf } from "../../src/vision/camera";
import { catalog } from "../fixture/catalogs";

const programOf = (text: string) => ({ files: [{ path: "robot.bhdl", text }] }) as unknown as Program;

it("reads how the camera is mounted from the program that ships", () => {
  const text = readFileSync(new URL("../../../bhdl/programs/office_robot.bhdl", import.meta.url), "utf8");
  expect(cameraOf(programOf(text.replace(/camera_height: \d+/, "camera_height: 31")), catalog)).toEqual({ height_m: 0.31, forward_m: 0.1 });
});

it("reads lengths in the program's own units", () => {
  const text = 'input_devices: frame_grabber: camera_height: 0.5 m camera_forward: -40 mm end end';
  expect(cameraOf(programOf(text), catalog)).toEqual({ height_m: 0.5, forward_m: -0.04 });
});

it("takes the robot's own defaults where the program says nothing", () => {
  expect(cameraOf(programOf(""), catalog)).toEqual({ height_m: 0.2, forward_m: 0.1 });
});
