// SPDX-License-Identifier: BSD-3-Clause
// Whether what the history tells of a push is what robots run.

/** What a robot tells that has taken a program. */
const TAKEN = ['running', 'confirmed'];

/** Which robot runs the push's program although the push does not tell so, or does not although it does; undefined: none. */
export function disagreement(push, robots) {
  const tells = (name) => TAKEN.includes(push.replies.find(({ robot }) => robot === name)?.status);
  const wrong = robots.find(({ name, program_hash }) => (program_hash === push.hash) !== tells(name));
  return wrong && `push ${push.id} is ${push.state} and tells that ${wrong.name} ${tells(wrong.name) ? 'runs' : 'does not run'} ${push.hash}, and it runs ${wrong.program_hash}`;
}
