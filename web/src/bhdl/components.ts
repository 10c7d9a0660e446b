// SPDX-License-Identifier: BSD-3-Clause
// A program's components as they stand in its text, and the text with one of their attributes changed.

import type { SyntaxNode } from "@lezer/common";
import type { SourceFile } from "../feed/messages";
import { parser } from "./bhdl.grammar";

export interface AttributeText {
  /** As written; of a single text, without its quotes. */
  value: string;
  from: number;
  to: number;
}

export interface ComponentText {
  file: number;
  type: string;
  name: string;
  attributes: Map<string, AttributeText>;
  /** Where another attribute may be put: behind the name. */
  insertAt: number;
}

const QUOTES = /^["“”„‟]|["“”„‟]$/g;

function attributeOf(node: SyntaxNode, text: string): [string, AttributeText] | undefined {
  const label = node.getChild("AttributeLabel");
  const first = label?.nextSibling?.nextSibling;
  const last = node.lastChild;
  if (!label || !first || !last) return undefined;
  const value = text.slice(first.from, last.to);
  const only = first.from === last.from && first.name === "Text";
  return [text.slice(label.from, label.to), { value: only ? value.replace(QUOTES, "") : value, from: first.from, to: last.to }];
}

function componentOf(node: SyntaxNode, text: string, file: number): ComponentText {
  const label = node.getChild("ComponentLabel")!;
  const attributes = new Map<string, AttributeText>();
  for (const each of node.getChildren("Attribute")) {
    const attribute = attributeOf(each, text);
    if (attribute) attributes.set(...attribute);
  }
  const name = attributes.get("name");
  const insertAt = name?.to ?? text.indexOf(":", label.to) + 1;
  return { file, type: text.slice(label.from, label.to), name: name?.value ?? "", attributes, insertAt };
}

const known = new WeakMap<readonly SourceFile[], readonly ComponentText[]>();

/** All components of the files, in the order of the texts; the same files are read once. */
export function componentsOf(files: readonly SourceFile[]): readonly ComponentText[] {
  const components = known.get(files) ?? read(files);
  known.set(files, components);
  return components;
}

function read(files: readonly SourceFile[]): ComponentText[] {
  const components: ComponentText[] = [];
  files.forEach(({ text }, file) =>
    parser.parse(text).iterate({
      enter: (node) => void (node.name === "Component" && components.push(componentOf(node.node, text, file))),
    }),
  );
  return components;
}

/** The files with `attribute: value` in that component; it must be one of these files' own. */
export function withAttribute(files: readonly SourceFile[], component: ComponentText, attribute: string, value: string): SourceFile[] {
  return files.map((file, index) => {
    if (index !== component.file) return file;
    const { text } = file;
    const known = component.attributes.get(attribute);
    const [from, to, put] = known ? [known.from, known.to, value] : [component.insertAt, component.insertAt, `  ${attribute}: ${value}`];
    return { ...file, text: text.slice(0, from) + put + text.slice(to) };
  });
}
