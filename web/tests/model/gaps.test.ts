// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { drawnGaps, withGap } from "../../src/model/gaps";

describe("times in which nothing was heard", () => {
  const gap = { from_ms: 1000, to_ms: 4000 };

  it("are cut to what is shown", () => {
    expect(drawnGaps([gap], undefined, 2000, 9000)).toEqual([{ from_ms: 2000, to_ms: 4000 }]);
    expect(drawnGaps([gap], undefined, 5000, 9000)).toEqual([]);
  });

  it("last until now where they have not ended", () => {
    expect(drawnGaps([], 6000, 2000, 9000)).toEqual([{ from_ms: 6000, to_ms: 9000 }]);
  });

  it("are forgotten with what else is older than ten minutes", () => {
    expect(withGap([gap], { from_ms: 700_000, to_ms: 701_000 })).toHaveLength(1);
  });
});
