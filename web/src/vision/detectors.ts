// SPDX-License-Identifier: BSD-3-Clause
// The schemas of a program that find things in pictures: in which picture each looks, and from which
// brightness on.

import type { Catalog } from "../bhdl/catalog";
import { type ComponentText, componentsOf } from "../bhdl/components";
import type { SourceFile } from "../feed/messages";
import { CAMERA, type Picture } from "../feed/topics";
import type { Threshold } from "./blobs";

export interface Detector {
  component: ComponentText;
  name: string;
  picture: Picture;
  threshold: Threshold;
  minArea_px: number;
  /** The attributes that hold the threshold and the least area; undefined: it has no least area. */
  attributes: { threshold: string; leastArea: string | undefined };
}

/** A robot's pictures, its camera's first. */
export function picturesOf(catalog: Catalog | undefined): readonly Picture[] {
  return [CAMERA, ...(catalog?.channels ?? [])];
}

/** The pictures that the program makes, by the image variables that hold them. */
function pictureOfImages(components: readonly ComponentText[], catalog: Catalog): ReadonlyMap<string, Picture> {
  const pictures = components.flatMap((component) =>
    catalog
      .attributes(component.type)
      .filter(({ role }) => role === "channel")
      .map(({ name, of }) => [catalog.valueOf(component, name), of ?? ""] as const),
  );
  return new Map(pictures.filter(([variable]) => variable !== ""));
}

/** In which picture things are found, by the locate variable that they feed. */
export function pictureOfVariables(files: readonly SourceFile[], catalog: Catalog): ReadonlyMap<string, Picture> {
  const components = componentsOf(files);
  const pictures = pictureOfImages(components, catalog);
  return new Map(
    components.flatMap((component) => {
      const sighting = catalog.attribute(component.type, "sighting");
      const picture = sighting?.of && pictures.get(catalog.valueOf(component, sighting.of));
      return sighting && picture ? [[catalog.valueOf(component, sighting.name), picture] as const] : [];
    }),
  );
}

function detectorOf(component: ComponentText, pictures: ReadonlyMap<string, Picture>, catalog: Catalog): Detector[] {
  const { type, name } = component;
  const threshold = catalog.attribute(type, "threshold");
  const picture = threshold?.of && pictures.get(catalog.valueOf(component, threshold.of));
  if (!threshold || !picture) return [];
  const [polarity, leastArea] = [catalog.attribute(type, "polarity"), catalog.attribute(type, "least_area")];
  const dark = polarity !== undefined && catalog.valueOf(component, polarity.name) === "dark";
  const level = catalog.quantityOf(component, threshold);
  const minArea_px = leastArea ? catalog.quantityOf(component, leastArea) : 1;
  if (!Number.isFinite(level) || !Number.isFinite(minArea_px)) return [];
  return [{ component, name, picture, threshold: { level, dark }, minArea_px, attributes: { threshold: threshold.name, leastArea: leastArea?.name } }];
}

/** Those whose picture and numbers stand in the program or in the robot's catalog; constants and bases are not followed. */
export function detectorsOf(files: readonly SourceFile[], catalog: Catalog): Detector[] {
  const components = componentsOf(files);
  const pictures = pictureOfImages(components, catalog);
  return components.flatMap((component) => detectorOf(component, pictures, catalog));
}
