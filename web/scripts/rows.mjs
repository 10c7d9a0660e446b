// SPDX-License-Identifier: BSD-3-Clause
// The table that performance.mjs prints: what was measured, what is wanted, and what was seen or why nothing was.

export class Rows {
  #rows = [];
  #underWay = [];
  #isOver = false;
  /** Whether anything could not be measured. */
  failed = false;

  /** Adds a row: what `measure` tells, or why it could not be measured. */
  async add(what, wanted, measure) {
    const underWay = { what, wanted };
    this.#underWay.push(underWay);
    try {
      this.#put(what, wanted, await measure());
    } catch ({ message }) {
      this.#miss(what, wanted, message);
    }
    this.#underWay = this.#underWay.filter((each) => each !== underWay);
  }

  /** No row comes after this: what is still measured was not, for this reason. */
  end(reason) {
    for (const { what, wanted } of this.#underWay) this.#miss(what, wanted, reason);
    this.#isOver = true;
  }

  #miss(what, wanted, reason) {
    this.failed = true;
    this.#put(what, wanted, `not measured: ${reason.split("\n")[0]}`);
  }

  #put(...row) {
    if (this.#isOver) return;
    this.#rows.push(row);
    console.error(`${row[0]}: ${row[2]}`);
  }

  print(title) {
    const table = [["what", "wanted", "seen"], ...this.#rows];
    const widths = [0, 1, 2].map((column) => Math.max(...table.map((row) => row[column].length)));
    const line = (cells) => `| ${cells.map((cell, i) => cell.padEnd(widths[i])).join(" | ")} |`;
    const [head, ...seen] = table.map(line);
    console.log(["", title, "", head, line(widths.map((width) => "-".repeat(width))), ...seen].join("\n"));
  }
}
