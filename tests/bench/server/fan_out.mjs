// SPDX-License-Identifier: BSD-3-Clause
// 1 KB from one client to 100, in messages a second, beside Beast's own example websocket/server/chat-multi:
//   node tests/bench/server/fan_out.mjs
// The example is built from the sources in Debian's libboost1.81-doc, or below BOOST_EXAMPLES.
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import { answers, bench, build, freePort, inTurns, output, program, start } from './tools.mjs';

const examples = process.env.BOOST_EXAMPLES ?? '/usr/share/doc/libboost1.81-doc/examples';
const sources = `${examples}/libs/beast/example/websocket/server/chat-multi`;

function builtExample() {
  const example = `${build}/bench/chat-multi`;
  if (existsSync(example)) return example;
  if (!existsSync(sources)) throw new Error(`${sources} is missing: apt-get install libboost1.81-doc, or set BOOST_EXAMPLES`);
  mkdirSync(`${build}/bench`, { recursive: true });
  const files = readdirSync(sources).filter((name) => name.endsWith('.cpp')).map((name) => `${sources}/${name}`);
  output('c++', ['-std=c++20', '-O2', '-w', '-I', examples, ...files, '-o', example, '-lpthread']);
  return example;
}

await bench(async () => {
  const example = builtExample();
  const port = await freePort(), ours = await freePort();
  start(example, ['127.0.0.1', String(port), '/nowhere', '1'], { stdio: 'ignore' });
  await fetch(`http://127.0.0.1:${port}/`).catch(() => answers(`http://127.0.0.1:${port}/`));
  const measure = (...args) => Number(output(program('fan_out_bench'), args));
  const { monitor, chat } = await inTurns(3, {
    monitor: () => measure(String(ours)),
    chat: () => measure(String(port), 'chat'),
  });
  console.log(`1 KB to 100 clients: monitor ${(monitor / 1e3).toFixed(0)} k messages/s, chat-multi ${(chat / 1e3).toFixed(0)} k, `
    + `${(monitor / chat).toFixed(1)} times as many`);
});
