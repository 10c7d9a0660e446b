// SPDX-License-Identifier: BSD-3-Clause
// How a robot's camera looks at the floor, as its program says: robot/vision/camera_model.

import type { AttributeSpec, Catalog, Role } from "../bhdl/catalog";
import { type ComponentText, componentsOf } from "../bhdl/components";
import type { Program } from "../feed/messages";

export interface Camera {
  readonly height_m: number;
  /** Of the camera, ahead of the robot's middle. */
  readonly forward_m: number;
}

/** Where neither the program nor the robot's catalog says anything that can be read. */
const STANDARD: Camera = { height_m: 0.2, forward_m: 0.1 };

export function cameraOf(program: Program | undefined, catalog: Catalog | undefined): Camera {
  const type = catalog?.componentWith("camera_height");
  if (!program || !catalog || !type) return STANDARD;
  const undeclared: ComponentText = { file: 0, type, name: "", attributes: new Map(), insertAt: 0 };
  const component = componentsOf(program.files).find((each) => each.type === type) ?? undeclared;
  const metres = (role: Role, otherwise_m: number) => {
    const attribute: AttributeSpec | undefined = catalog.attribute(type, role);
    const value_m = attribute ? catalog.quantityOf(component, attribute) : Number.NaN;
    return Number.isFinite(value_m) ? value_m : otherwise_m;
  };
  return { height_m: metres("camera_height", STANDARD.height_m), forward_m: metres("camera_forward", STANDARD.forward_m) };
}
