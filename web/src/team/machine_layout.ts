import dagre from "@dagrejs/dagre";
import type { Machine, MachineTransition } from "../feed/messages";

export interface LaidState {
  readonly name: string;
  readonly lines: readonly string[];
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** All transitions from one state to another, as one arrow. */
export interface LaidArrow {
  readonly from: string;
  readonly to: string;
  readonly path: string;
  readonly transitions: readonly MachineTransition[];
}

export interface MachineLayout {
  readonly width: number;
  readonly height: number;
  readonly states: readonly LaidState[];
  readonly arrows: readonly LaidArrow[];
}

const CHARACTER_PX = 6.7;
const LINE_PX = 14;
const LONGEST_LINE = 11;
const MARGIN_PX = 6;

/** A long name on two lines, broken at the underscore nearest its middle. */
export function labelLines(name: string): string[] {
  const middle = name.length / 2;
  const breaks = [...name.matchAll(/_/g)].map((match) => match.index);
  if (name.length <= LONGEST_LINE || breaks.length === 0) return [name];
  const at = breaks.reduce((best, place) => (Math.abs(place - middle) < Math.abs(best - middle) ? place : best));
  return [name.slice(0, at + 1), name.slice(at + 1)];
}

type Point = { x: number; y: number };

/** A curve through the middles of a line's pieces, with the given ends. */
function curve(points: readonly Point[]): string {
  const [first, ...rest] = points;
  if (!first || rest.length === 0) return "";
  const round = ({ x, y }: Point) => `${x.toFixed(1)},${y.toFixed(1)}`;
  const last = rest.at(-1)!;
  const pieces = rest.slice(0, -1).map((point, i) => {
    const next = rest[i + 1]!;
    return `Q${round(point)} ${round({ x: (point.x + next.x) / 2, y: (point.y + next.y) / 2 })}`;
  });
  return `M${round(first)} ${pieces.join(" ")} L${round(last)}`;
}

function arrowsOf(machine: Machine): Map<string, MachineTransition[]> {
  const arrows = new Map<string, MachineTransition[]>();
  for (const transition of machine.transitions) {
    const key = JSON.stringify([transition.from_state, transition.to_state]);
    arrows.set(key, [...(arrows.get(key) ?? []), transition]);
  }
  return arrows;
}

function graphOf(machine: Machine, arrows: Map<string, MachineTransition[]>) {
  const graph = new dagre.graphlib.Graph();
  graph.setGraph({ rankdir: "TB", nodesep: 14, ranksep: 22, edgesep: 8, marginx: MARGIN_PX, marginy: MARGIN_PX });
  graph.setDefaultEdgeLabel(() => ({}));
  for (const { name } of machine.states) {
    const lines = labelLines(name);
    const width = Math.max(...lines.map((line) => line.length)) * CHARACTER_PX + 18;
    graph.setNode(name, { width: Math.max(width, 56), height: lines.length * LINE_PX + 8 });
  }
  for (const key of arrows.keys()) {
    const [from, to] = JSON.parse(key) as [string, string];
    if (graph.hasNode(from) && graph.hasNode(to)) graph.setEdge(from, to);
  }
  return graph;
}

/** Where a machine's states and arrows are drawn, in pixels at scale 1; the start state comes first. */
export function layOut(machine: Machine): MachineLayout {
  const start = machine.states.filter((state) => state.name === machine.start_state);
  const others = machine.states.filter((state) => state.name !== machine.start_state);
  const arrows = arrowsOf(machine);
  const graph = graphOf({ ...machine, states: [...start, ...others] }, arrows);
  dagre.layout(graph);
  const states = graph.nodes().map((name) => ({ name, lines: labelLines(name), ...box(graph.node(name)) }));
  return { ...extent(graph), states, arrows: drawnArrows(graph, arrows) };
}

/** dagre's own width leaves out how far arrows swing. */
function extent(graph: dagre.graphlib.Graph): { width: number; height: number } {
  const { width = 0, height = 0 } = graph.graph();
  const bends = graph.edges().flatMap((edge) => graph.edge(edge).points as Point[]);
  return {
    width: Math.max(width, ...bends.map(({ x }) => x + MARGIN_PX)),
    height: Math.max(height, ...bends.map(({ y }) => y + MARGIN_PX)),
  };
}

function box({ x, y, width, height }: { x: number; y: number; width: number; height: number }) {
  return { x: x - width / 2, y: y - height / 2, width, height };
}

function drawnArrows(graph: dagre.graphlib.Graph, arrows: Map<string, MachineTransition[]>): LaidArrow[] {
  return graph.edges().map(({ v: from, w: to }) => ({
    from,
    to,
    path: curve(graph.edge(from, to).points),
    transitions: arrows.get(JSON.stringify([from, to])) ?? [],
  }));
}
