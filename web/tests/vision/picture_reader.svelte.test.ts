// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, expect, it, vi } from "vitest";
import type { PageFeed } from "../../src/feed/page_feed";
import { PictureReader } from "../../src/vision/picture_reader.svelte";
import { live } from "../fixture/fake_live.svelte";

vi.mock("../../src/model/live.svelte", () => import("../fixture/fake_live.svelte"));

const IO = "/io/camera/compressed";
const picture = (sec: number, width = 200) => ({ topic: IO, bitmap: { width, height: 100 }, taken: { sec, nsec: 0 } });
let wanted: string[];
let drawn: unknown[];
let canvas: HTMLCanvasElement;
let reader: PictureReader;
const feed = { want: (topic: string) => (wanted.push(topic), () => (wanted = wanted.filter((each) => each !== topic))) } as unknown as PageFeed;
beforeEach(() => {
  [wanted, drawn] = [[], []];
  canvas = { width: 0, height: 0, getContext: () => ({ drawImage: ({ width }: { width: number }) => drawn.push(width), clearRect: () => drawn.push("nothing") }) } as unknown as HTMLCanvasElement;
  reader = new PictureReader();
  live.reset();
});

it("draws a picture as it comes, and tells so", () => {
  const told = vi.fn();
  reader.read(feed, "io", "camera", canvas, told);
  live.hear(IO, picture(1));
  expect([drawn, canvas.width, reader.width_px, reader.taken, reader.count, told.mock.calls.length]).toEqual([[200], 200, 200, { sec: 1, nsec: 0 }, 1, 1]);
});

it("asks for a picture no longer than it is read", () => {
  const end = reader.read(feed, "io", "camera", canvas);
  expect(wanted).toEqual([IO]);
  end();
  live.hear(IO, picture(1));
  expect([wanted, drawn]).toEqual([[], []]);
});

it("says of another robot's picture nothing that it knew of the one before", () => {
  const end = reader.read(feed, "io", "camera", canvas);
  live.hear(IO, picture(1));
  end();
  reader.read(feed, "io", "camera", canvas);
  expect([reader.count, reader.taken?.sec]).toEqual([1, 1]);
  reader.read(feed, "ganymede", "camera", canvas);
  expect([reader.count, reader.taken, reader.shown_ms, reader.rate_hz]).toEqual([0, undefined, 0, 0]);
});

it("shows nothing, and asks anew, where a recording goes on from another instant", () => {
  const end = reader.read(feed, "io", "camera", canvas);
  live.hear(IO, picture(1));
  live.rewind(0);
  expect([drawn, reader.count, reader.taken, wanted]).toEqual([[200, "nothing"], 0, undefined, [IO]]);
  end();
  expect(wanted).toEqual([]);
});
