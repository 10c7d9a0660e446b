// What a robot says that its programs may name: the catalog it publishes.

interface AttributeSpec {
  name: string;
  default?: unknown;
}
interface ComponentSpec {
  name: string;
  attributes: AttributeSpec[];
}

export class Catalog {
  #components: Map<string, ComponentSpec>;

  /** Throws where `json` is no catalog. */
  constructor(json: string) {
    const { components } = JSON.parse(json) as { components: ComponentSpec[] };
    this.#components = new Map(components.map((component) => [component.name, component]));
  }

  /** The value that counts where a program gives none; undefined where one must be given. */
  defaultOf(component: string, attribute: string): unknown {
    return this.#components.get(component)?.attributes.find(({ name }) => name === attribute)?.default;
  }
}
