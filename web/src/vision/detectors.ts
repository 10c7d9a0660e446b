// The blob detectors of a program: in which picture each looks, and from which brightness on.

import type { Catalog } from "../bhdl/catalog";
import { type ComponentText, componentsOf } from "../bhdl/components";
import type { SourceFile } from "../feed/messages";
import type { Picture } from "../feed/topics";
import type { Threshold } from "./blobs";

export interface Detector {
  component: ComponentText;
  name: string;
  picture: Picture;
  threshold: Threshold;
  minArea_px: number;
}

const PICTURES: readonly [attribute: string, picture: Picture][] = [
  ["red_variable", "superred"],
  ["green_variable", "supergreen"],
  ["blue_variable", "superblue"],
  ["dark_variable", "dark"],
];

function picturesOf(components: readonly ComponentText[]): Map<string, Picture> {
  const looks = components.filter(({ type }) => type === "look");
  return new Map(looks.flatMap(({ attributes }) => PICTURES.map(([attribute, picture]) => [attributes.get(attribute)?.value ?? "", picture] as const)));
}

const known = new WeakMap<readonly SourceFile[], ReadonlyMap<string, Picture>>();

/** In which picture things are found, by the locate variable that they feed. */
export function pictureOfVariables(files: readonly SourceFile[]): ReadonlyMap<string, Picture> {
  const before = known.get(files);
  if (before) return before;
  const components = componentsOf(files);
  const pictures = picturesOf(components);
  const found = components
    .filter(({ type }) => type === "blob_detector")
    .flatMap(({ attributes }) => {
      const picture = pictures.get(attributes.get("image_variable")?.value ?? "");
      return picture ? [[attributes.get("locate_variable")?.value ?? "", picture] as const] : [];
    });
  const map = new Map(found);
  known.set(files, map);
  return map;
}

/** Those whose picture and numbers stand in the program or in the robot's catalog; constants and bases are not followed. */
export function detectorsOf(files: readonly SourceFile[], catalog: Catalog): Detector[] {
  const components = componentsOf(files);
  const pictures = picturesOf(components);
  return components.flatMap((component) => {
    if (component.type !== "blob_detector") return [];
    const valueOf = (attribute: string): unknown => component.attributes.get(attribute)?.value ?? catalog.defaultOf("blob_detector", attribute);
    const picture = pictures.get(String(valueOf("image_variable")));
    const [level, minArea_px] = [Number.parseFloat(String(valueOf("threshold"))), Number.parseFloat(String(valueOf("min_area")))];
    if (!picture || !Number.isFinite(level) || !Number.isFinite(minArea_px)) return [];
    return [{ component, name: component.name, picture, threshold: { level, dark: valueOf("polarity") === "dark" }, minArea_px }];
  });
}
