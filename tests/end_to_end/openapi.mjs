// SPDX-License-Identifier: BSD-3-Clause
// What docs/openapi.yaml promises, as checks of answers.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { root } from './tools.mjs';

const require = createRequire(`${root}tests/node/`);
const { default: Ajv2020 } = require('ajv/dist/2020');
const { createConfig, lintFromString, stringifyYaml, parseYaml } = require('@redocly/openapi-core');

export const file = `${root}docs/openapi.yaml`;
const source = readFileSync(file, 'utf8');
export const description = parseYaml(source);

/** What Redocly's linter objects to. The project has no licence to name yet. */
export async function lint() {
  const config = await createConfig({ extends: ['recommended-strict'], rules: { 'info-license': 'off' } });
  const problems = await lintFromString({ source, absoluteRef: file, config });
  return problems.map((problem) => `${problem.location[0]?.pointer}: ${problem.message}`);
}

const unions = new Set(['allOf', 'oneOf', 'anyOf']);

/** The same description, in which an object may have no members but those that are described. */
function closed(node, inUnion = false) {
  if (Array.isArray(node)) return node.map((each) => closed(each, inUnion));
  if (node === null || typeof node !== 'object') return node;
  const copy = Object.fromEntries(Object.entries(node).map(([key, value]) => [key, closed(value, unions.has(key))]));
  const describesMembers = node.$ref?.startsWith('#/components/schemas/') || node.properties?.constructor === Object && node.type || node.allOf;
  return describesMembers && !inUnion ? { ...copy, unevaluatedProperties: false } : copy;
}

/** As schemas may be referred to from several places, they stay open, and each place closes them. */
function strictly(root) {
  const strict = closed(root);
  for (const schema of Object.values(strict.components.schemas)) delete schema.unevaluatedProperties;
  return strict;
}

const ajv = new Ajv2020({ strict: false, allErrors: true });
const id = 'http://galilean/openapi';
ajv.addSchema({ $id: id, ...strictly(description) });

const resolved = (node) => node?.$ref ? node.$ref.slice(2).split('/').reduce((at, key) => at[key], description) : node;
const escaped = (key) => encodeURIComponent(key.replaceAll('~', '~0').replaceAll('/', '~1'));

/** What is wrong about an answer to `method` on `path` (as the description writes it); empty: nothing. */
export async function objections(method, path, response) {
  const operation = description.paths[path]?.[method.toLowerCase()];
  if (!operation) return [`${method} ${path} is not described`];
  const reference = operation.responses[response.status];
  if (!reference) return [`${method} ${path} is not said to answer ${response.status}: ${await response.text()}`];
  const content = resolved(reference).content;
  const type = response.headers.get('content-type').split(';')[0];
  if (!content[type]) return [`${method} ${path}: ${type} is not among ${Object.keys(content)}`];
  if (!content[type].schema) return [];
  const pointer = reference.$ref ?? `#/paths/${escaped(path)}/${method.toLowerCase()}/responses/${response.status}`;
  const valid = ajv.compile({ $ref: `${id}${pointer}/content/${escaped(type)}/schema` });
  if (valid(await response.json())) return [];
  return valid.errors.map((error) => `${method} ${path} ${error.instancePath}: ${error.message} ${JSON.stringify(error.params)}`);
}
