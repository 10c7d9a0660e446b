// SPDX-License-Identifier: BSD-3-Clause
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { componentsOf, withAttribute } from "../../src/bhdl/components";
import { blobsOf, maskOf } from "../../src/vision/blobs";
import { detectorsOf, picturesOf, pictureOfVariables } from "../../src/vision/detectors";
import { catalog } from "../fixture/catalogs";

const programs = new URL("../../../bhdl/programs/", import.meta.url);
const office = ["office_cleanup.bhdl", "office_robot.bhdl"].map((path) => ({ path, text: readFileSync(new URL(path, programs), "utf8") }));

/** '#' is bright. */
function picture(...rows: string[]): Uint8Array {
  return Uint8Array.from(rows.join(""), (pixel) => (pixel === "#" ? 200 : 10));
}

test("pixels that touch by a corner are one blob, and small ones are left out", () => {
  const mask = maskOf(picture("#..#....", ".#......", "..#...##", "......##"), { level: 100, dark: false });
  expect(blobsOf(mask, 8, 2)).toEqual([
    { area_px: 4, left_px: 6, top_px: 2, right_px: 7, bottom_px: 3 },
    { area_px: 3, left_px: 0, top_px: 0, right_px: 2, bottom_px: 2 },
  ]);
});

test("bright is at least the level, dark is below it", () => {
  const pixels = Uint8Array.of(59, 60, 61);
  expect([...maskOf(pixels, { level: 60, dark: false })]).toEqual([0, 1, 1]);
  expect([...maskOf(pixels, { level: 60, dark: true })]).toEqual([1, 0, 0]);
});

test("a robot's pictures are its camera's and those that its catalog names", () => {
  expect(picturesOf(undefined)).toEqual(["camera"]);
  expect(picturesOf(catalog)).toEqual(["camera", "superred", "supergreen", "superblue", "dark"]);
});

test("what is found belongs over the picture that it was found in", () => {
  expect([...pictureOfVariables(office, catalog)]).toEqual([["trash", "superred"], ["robot", "supergreen"], ["basket", "dark"]]);
});

test("a program's detectors are found in the pictures that look writes", () => {
  expect(detectorsOf(office, catalog).map(({ name, picture, threshold, minArea_px }) => ({ name, picture, threshold, minArea_px }))).toEqual([
    { name: "trash_finder", picture: "superred", threshold: { level: 60, dark: false }, minArea_px: 8 },
    { name: "robot_finder", picture: "supergreen", threshold: { level: 40, dark: false }, minArea_px: 20 },
    { name: "basket_finder", picture: "dark", threshold: { level: 45, dark: true }, minArea_px: 60 },
  ]);
});

test("what a program leaves out is the catalog's", () => {
  const text = 'perceptual_schemas: look: red_variable: "r" end blob_detector: name: "f" image_variable: "r" end end';
  expect(detectorsOf([{ path: "a", text }], catalog)[0]).toMatchObject({ picture: "superred", threshold: { level: 60, dark: false }, minArea_px: 12 });
});

test("a threshold is changed in its place and nowhere else", () => {
  const finder = detectorsOf(office, catalog)[0]!.component;
  const changed = withAttribute(office, finder, "threshold", "75");
  expect(changed[0]).toBe(office[0]);
  expect(changed[1]!.text).toBe(office[1]!.text.replace("threshold: 60  min_area: 8", "threshold: 75  min_area: 8"));
  const with_polarity = withAttribute(office, finder, "polarity", '"bright"');
  expect(with_polarity[1]!.text).toContain('name: "trash_finder"  polarity: "bright"\n');
  expect(componentsOf(with_polarity).find(({ name }) => name === "trash_finder")?.attributes.get("polarity")?.value).toBe("bright");
});
