// SPDX-License-Identifier: BSD-3-Clause
import { beforeEach, describe, expect, it } from "vitest";
import { type DecodedPicture, PictureDecoder } from "../../src/feed/picture_decoder";
import { Questions } from "../fixture/answers";

const [IO, GANYMEDE] = ["/io/camera/compressed", "/ganymede/camera/compressed"];

describe("pictures that are made ready to be drawn", () => {
  let decoders: Questions;
  let closed: number;
  let shown: string[];
  let troubles: string[];
  let decoder: PictureDecoder;
  beforeEach(() => {
    [decoders, closed, shown, troubles] = [new Questions(), 0, [], []];
    const decode = decoders.operation("decode");
    decoder = new PictureDecoder(
      { picture: ({ topic, taken }: DecodedPicture) => shown.push(`${topic} ${taken.sec}`), trouble: (sentence) => troubles.push(sentence) },
      async (picture) => ((await decode(picture)), { close: () => (closed += 1) } as unknown as ImageBitmap),
    );
  });
  const come = (topic: string, sec: number) =>
    decoder.put({ topic, received_ms: 0, decode: () => ({ header: { stamp: { sec, nsec: 0 }, frame_id: "" }, format: "jpeg", data: new Uint8Array(1) }) });
  const ready = (nth: number) => decoders.of("decode", nth).answer(undefined);

  it("are handed over one at a time of each topic, and then only the newest", async () => {
    come(IO, 1);
    come(GANYMEDE, 1);
    await ready(0);
    await ready(1);
    for (const sec of [2, 3, 4]) come(IO, sec);
    expect(shown).toEqual([`${IO} 1`, `${GANYMEDE} 1`]);
    expect(decoders.count("decode")).toBe(2);
    decoder.shown(IO);
    await ready(2);
    expect(shown.slice(2)).toEqual([`${IO} 4`]);
  });
  it("are of nobody's robot once nobody looks, and are closed", async () => {
    come(IO, 1);
    decoder.forget(IO);
    await ready(0);
    expect([shown, closed]).toEqual([[], 1]);
    come(IO, 2);
    await ready(1);
    expect(shown).toEqual([`${IO} 2`]);
  });
  it("are told of where they are damaged, if anybody still looks, and the next one is drawn", async () => {
    come(IO, 1);
    decoder.forget(IO);
    await decoders.of("decode", 0).refuse(new Error("damaged"));
    expect(troubles).toEqual([]);
    come(IO, 2);
    await decoders.of("decode", 1).refuse(new Error("damaged"));
    expect(troubles).toEqual([expect.stringMatching(/^A jpeg picture on \/io\/camera\/compressed could not be drawn/)]);
    come(IO, 3);
    await ready(2);
    expect(shown).toEqual([`${IO} 3`]);
  });
  it("are told of where the message is damaged", () => {
    decoder.put({ topic: IO, received_ms: 0, decode: () => { throw new Error("too short"); } });
    expect(troubles).toEqual([expect.stringMatching(/^A picture on \/io\/camera/)]);
  });
});
