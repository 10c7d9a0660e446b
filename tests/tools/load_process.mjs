// SPDX-License-Identifier: BSD-3-Clause
// Clients of a monitor that take more than their part, in a process of their own: node load_process.mjs URL CHECKS FLOODS
// So many have a program of a megabyte checked, one after another, and so many ask for the status without end. It says
// "loading" when each has begun, and ends with its standard input.
const [url, checks, floods] = process.argv.slice(2);
/** A file may be no longer. */
const FILE_BYTES = 400_000;

/** A program that takes long to check. */
function longFile(name) {
  let text = 'states:\n';
  for (let state = 0; text.length < FILE_BYTES; ++state) text += `  state:\n    name: "${name}${state}"\n  end\n`;
  return { path: `${name}.bhdl`, text: `${text}end\n` };
}

const body = JSON.stringify({ files: ['first', 'second', 'third'].map(longFile) });
const pause = () => new Promise((resolve) => setTimeout(resolve, 50));

/** A client that is refused asks again, as some do. */
async function askForEver(path, options) {
  for (;;) {
    try {
      const answer = await fetch(`${url}${path}`, options);
      await answer.text();
      if (!answer.ok) await pause();
    } catch {
      await pause();
    }
  }
}

for (let i = 0; i < Number(checks); ++i) void askForEver('/api/check', { method: 'POST', body });
for (let i = 0; i < Number(floods); ++i) void askForEver('/api/status');
console.log('loading');
process.stdin.resume().on('end', () => process.exit(0));
