// How a robot's camera looks at the floor, as its program says: robot/vision/camera_model.

import { componentsOf } from "../bhdl/components";
import type { Program } from "../feed/messages";

export interface Camera {
  readonly height_m: number;
  /** Of the camera, ahead of the robot's middle. */
  readonly forward_m: number;
}

/** Where the program does not say: robot/devices' own defaults. */
const STANDARD: Camera = { height_m: 0.2, forward_m: 0.1 };
const cameras = new WeakMap<Program, Camera>();

export function cameraOf(program: Program | undefined): Camera {
  if (!program) return STANDARD;
  const known = cameras.get(program) ?? read(program);
  cameras.set(program, known);
  return known;
}

function read({ files }: Program): Camera {
  const grabber = componentsOf(files).find(({ type }) => type === "frame_grabber");
  const metres = (attribute: string, otherwise_m: number) => {
    const value_cm = Number.parseFloat(grabber?.attributes.get(attribute)?.value ?? "");
    return Number.isFinite(value_cm) ? value_cm / 100 : otherwise_m;
  };
  return { height_m: metres("camera_height", STANDARD.height_m), forward_m: metres("camera_forward", STANDARD.forward_m) };
}
