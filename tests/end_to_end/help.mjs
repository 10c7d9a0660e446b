// SPDX-License-Identifier: BSD-3-Clause
// What --help says of every verb and of every command in it.
import { galilean } from './tools.mjs';

const section = (help, title) => help.match(new RegExp(`^${title}:\n((?:  .*\n?)+)`, 'm'))?.[1] ?? '';

/** A line such as "  -h,--help   Print …" begins with names; what is further in goes on with the line above. */
const firstWords = (text) => [...text.matchAll(/^ {2}(\S+)/gm)].map(([, word]) => word);

/** `verbs` of `galilean help`, each a list of words, and the words that galilean obeys by itself. */
export function verbs() {
  const listed = galilean(['help']).stdout.match(/^ {2}\S+( \S+)?(?= {2,})/gm).map((line) => line.trim());
  return listed.filter((verb) => !ownWords.includes(verb)).map((verb) => verb.split(' '));
}
export const ownWords = ['version', 'help'];

function placesAt(path, isVerb) {
  const help = galilean([...path, '--help']).stdout;
  const options = firstWords(section(help, 'Options')).flatMap((names) => names.split(','));
  const commands = firstWords(section(help, 'Subcommands'));
  const inner = commands.map((command) => [...path, command]).filter((each) => !isVerb(each));
  return [{ path, options, commands }, ...inner.flatMap((each) => placesAt(each, isVerb))];
}

/** Every place where options can stand: `path` is the words before them. */
export function places() {
  const all = verbs();
  const isVerb = (path) => all.some((verb) => verb.join(' ') === path.join(' '));
  return all.flatMap((verb) => placesAt(verb, isVerb));
}
