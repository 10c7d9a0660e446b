// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, expect, it, vi } from "vitest";
import type { PageFeed } from "../../src/feed/page_feed";
import { PictureReader } from "../../src/vision/picture_reader.svelte";
import { Questions } from "../fixture/answers";
import { live } from "../fixture/fake_live.svelte";

vi.mock("../../src/model/live.svelte", () => import("../fixture/fake_live.svelte"));

const taken = (sec: number) => ({ header: { stamp: { sec, nsec: 0 }, frame_id: "" }, format: "jpeg", data: new Uint8Array() });
const feed = { want: () => () => {} } as unknown as PageFeed;
let decoders: Questions;
let closed: number;
let shown: unknown[];
let canvas: HTMLCanvasElement;
let reader: PictureReader;
beforeEach(() => {
  [decoders, closed, shown] = [new Questions(), 0, []];
  const decode = decoders.operation("decode");
  const bitmapOf = (width: number) => ({ width, height: 100, close: () => (closed += 1) });
  vi.stubGlobal("createImageBitmap", () => decode().then((width) => bitmapOf(width as number)));
  canvas = { width: 0, height: 0, getContext: () => ({ drawImage: ({ width }: { width: number }) => shown.push(width) }) } as unknown as HTMLCanvasElement;
  reader = new PictureReader();
  live.reset();
});

it("draws a picture as it comes, and tells so", async () => {
  const drawn = vi.fn();
  reader.read(feed, "io", "camera", canvas, drawn);
  live.hear("/io/camera/compressed", taken(1));
  expect(drawn).not.toHaveBeenCalled();
  await decoders.of("decode").answer(200);
  expect([shown, reader.width_px, reader.taken, drawn.mock.calls.length, closed]).toEqual([[200], 200, { sec: 1, nsec: 0 }, 1, 1]);
});

it("skips what comes while one is decoded, and tells of no picture that it skipped", async () => {
  const drawn = vi.fn();
  reader.read(feed, "io", "camera", canvas, drawn);
  live.hear("/io/camera/compressed", taken(1));
  live.hear("/io/camera/compressed", taken(2));
  await decoders.of("decode").answer(200);
  expect([decoders.count("decode"), drawn.mock.calls.length, reader.count]).toEqual([1, 1, 1]);
});

it("draws no picture of the robot before under the next one's name", async () => {
  const end = reader.read(feed, "io", "camera", canvas);
  live.hear("/io/camera/compressed", taken(1));
  end();
  reader.read(feed, "ganymede", "camera", canvas);
  await decoders.of("decode", 0).answer(200);
  expect([shown, closed]).toEqual([[], 1]);
  live.hear("/ganymede/camera/compressed", taken(2));
  await decoders.of("decode", 1).answer(300);
  expect([shown, reader.taken?.sec]).toEqual([[300], 2]);
});

it("says of another robot's picture nothing that it knew of the one before", async () => {
  const end = reader.read(feed, "io", "camera", canvas);
  live.hear("/io/camera/compressed", taken(1));
  await decoders.of("decode").answer(200);
  end();
  reader.read(feed, "io", "camera", canvas);
  expect([reader.count, reader.taken?.sec]).toEqual([1, 1]);
  reader.read(feed, "ganymede", "camera", canvas);
  expect([reader.count, reader.taken, reader.shown_ms, reader.rate_hz]).toEqual([0, undefined, 0, 0]);
});

it("tells of a picture that is damaged, if anybody still looks", async () => {
  const end = reader.read(feed, "io", "camera", canvas);
  live.hear("/io/camera/compressed", taken(1));
  end();
  await decoders.of("decode").refuse(new Error("damaged"));
  expect(live.trouble).toBeUndefined();
  reader.read(feed, "io", "camera", canvas);
  live.hear("/io/camera/compressed", taken(2));
  await decoders.of("decode").refuse(new Error("damaged"));
  expect(live.trouble).toMatch(/damaged/);
});
