// SPDX-License-Identifier: BSD-3-Clause
// Which rooms there are, and which rooms of its own top folder each may include. A new room is a line
// here. Files that stand on top of a folder, such as bhdl/check.h, are the room '.'; they and programs'
// entrances may include all rooms below them, so they are listed without an account of what.
const ANY = '*';

export const rooms = {
  core: {
    '.': [],
    variable: ['.'],
    device: ['.'],
    schema: ['.'],
    catalog: ['.', 'variable', 'device', 'schema'],
    command_line: ['.'],
    signing: ['.'],
    wire: ['.'],
    'wire/types': ['.', 'wire'],
    orders: ['.', 'signing', 'wire'],
    'wire/authentication': ['.'],
    'wire/generate': [],
  },
  bhdl: {
    '.': ANY,
    source: [],
    program: ['source'],
    syntax: ['source'],
    check: ['source', 'program', 'syntax'],
    lint: ['source', 'program', 'syntax', 'check'],
    format: ['source', 'syntax'],
    diff: ['source', 'program', 'check'],
    graph: ['source', 'program'],
    'lsp/documents': ['source', 'syntax', 'check'],
    'lsp/protocol': ['source', 'lsp/documents'],
    'lsp/features': ['.', 'source', 'syntax', 'check', 'format', 'lsp/documents', 'lsp/protocol'],
    lsp: ['source', 'lsp/protocol', 'lsp/features'],
    commands: ANY,
  },
  robot: {
    '.': ANY,
    log: [],
    firmware: [],
    devices: ['firmware'],
    variables: [],
    vision: [],
    perceptual: ['variables', 'vision'],
    motor: ['variables'],
    executive: ['devices', 'variables'],
    inputs: ['executive'],
    rerun: ['.', 'executive', 'inputs'],
    rehearsal: ['.', 'executive'],
    telemetry: ['executive', 'inputs', 'log'],
    watch: ['executive', 'log'],
    restart: [],
  },
  sim: {
    '.': ANY,
    scenario: [],
    world: ['scenario'],
    camera: ['scenario', 'world'],
    devices: ['world', 'camera'],
    control: ['world'],
    telemetry: ['world'],
    headless: ['scenario', 'world', 'control', 'devices'],
    live: ['camera', 'control', 'devices', 'telemetry'],
  },
  monitor: {
    '.': ANY,
    access: [],
    lease: ['access'],
    tls: [],
    keys: ['tls'],
    background: [],
    compression: [],
    ingest: [],
    mcap: [],
    team: ['ingest'],
    trial: ['team'],
    programs: [],
    'pushes/history': [],
    'pushes/rollout': ['pushes/history'],
    pushes: ['background', 'ingest', 'programs', 'team', 'trial', 'pushes/history', 'pushes/rollout'],
    map: ['ingest', 'map/estimation', 'map/landmarks', 'map/relocalization', 'map/groups', 'map/evidence', 'map/export'],
    'map/estimation': [],
    'map/landmarks': ['map/estimation'],
    'map/relocalization': ['map/estimation', 'map/landmarks'],
    'map/groups': ['map/estimation', 'map/landmarks', 'map/relocalization'],
    'map/evidence': ['map/estimation', 'map/groups'],
    'map/export': ['compression'],
    'server/text': [],
    'server/tls': ['tls'],
    'server/limits': [],
    'server/websocket': ['background', 'ingest', 'server/limits'],
    'server/foxglove': ['access', 'background', 'ingest', 'server/text', 'server/websocket', 'server/limits'],
    'server/lsp': ['background', 'team', 'server/text', 'server/websocket'],
    'server/replay': ['background', 'mcap', 'playback', 'record', 'recordings', 'server/text', 'server/websocket', 'server/foxglove', 'server/limits'],
    'server/http': ['access', 'background', 'compression', 'server/text', 'server/websocket', 'server/foxglove', 'server/lsp', 'server/replay', 'server/tls', 'server/limits'],
    'server/api': ['background', 'coverage', 'ingest', 'map', 'map/export', 'programs', 'pushes', 'pushes/history', 'mcap', 'record', 'recordings', 'team', 'server/text', 'server/foxglove', 'server/http', 'simulation', 'server/limits', 'access', 'lease'],
    server: ['access', 'tls', 'background', 'ingest', 'map', 'programs', 'pushes', 'pushes/history', 'recordings', 'team', 'server/foxglove', 'server/api', 'simulation', 'server/limits'],
    record: ['mcap', 'wire'],
    playback: ['mcap', 'record'],
    coverage: ['mcap', 'playback', 'wire'],
    recordings: ['mcap', 'record', 'playback'],
    replay: ['mcap', 'record', 'playback'],
    schemas: ['mcap', 'wire'],
    'logs/reading': ['mcap', 'record', 'replay', 'schemas'],
    'logs/printing': ['record', 'wire', 'logs/reading'],
    'logs/pictures': ['mcap'],
    'logs/figures': ['mcap', 'record', 'schemas', 'wire', 'logs/reading', 'logs/pictures'],
    'logs/writing': ['mcap', 'record', 'playback', 'schemas', 'logs/reading'],
    'logs/comparing': ['record', 'schemas', 'logs/reading', 'logs/printing'],
    'logs/coverage': ['mcap', 'coverage', 'logs/reading'],
    'logs/rerunning': ['record', 'replay', 'logs/reading'],
    logs: ['record', 'logs/reading', 'logs/printing', 'logs/figures', 'logs/writing', 'logs/comparing', 'logs/coverage', 'logs/rerunning'],
    'expect/language': [],
    'expect/judge': ['expect/language', 'wire'],
    'expect/recording': ['expect/judge', 'mcap', 'record', 'replay', 'schemas', 'wire'],
    'expect/live': ['expect/judge', 'expect/recording', 'record', 'wire'],
    'record/control': ['record'],
    'record/command': ['record', 'record/control', 'mcap', 'wire', 'expect/language', 'expect/judge', 'expect/live'],
    'expect/problems': [],
    'expect/report': ['expect/language', 'expect/judge', 'expect/problems', 'record'],
    expect: ['mcap', 'expect/language', 'expect/judge', 'expect/recording', 'expect/live', 'expect/problems', 'expect/report', 'wire'],
    'top/screen': [],
    'top/model': ['ingest', 'team'],
    'top/panels': ['team', 'top/screen', 'top/model'],
    orders: ['access', 'commands', 'team'],
    'top/push': ['commands', 'pushes/history', 'top/panels'],
    'top/gains': ['team'],
    'top/steering': ['orders', 'team', 'top/model'],
    'top/sheets': ['orders', 'team', 'top/screen', 'top/model', 'top/panels', 'top/push', 'top/gains', 'top/steering'],
    top: ['access', 'commands', 'orders', 'ingest', 'team', 'top/screen', 'top/model', 'top/panels', 'top/push', 'top/steering', 'top/sheets'],
    commands: ['access', 'tls', 'ingest', 'pushes', 'pushes/history', 'team', 'keys'],
    simulation: ['background'],
    wire: [],
    front: [],
    'front/demo': ['access', 'ingest', 'expect/problems', 'front'],
    'front/doctor': ['commands', 'front'],
    'front/manual': ['front'],
  },
  web: {
    '.': ANY,
    lib: [],
    feed: ['lib'],
    bhdl: ['feed'],
    model: ['lib', 'feed', 'bhdl'],
    parts: ['lib', 'feed', 'model'],
    layout: ['lib', 'parts'],
    graph: ['feed'],
    'program/editor': ['lib', 'feed', 'bhdl', 'model'],
    program: ['lib', 'feed', 'model', 'parts', 'layout', 'graph', 'program/editor'],
    gains: ['lib', 'feed', 'bhdl', 'model', 'parts', 'layout', 'program'],
    vision: ['lib', 'feed', 'bhdl', 'model', 'parts', 'layout', 'program'],
    map: ['lib', 'feed', 'bhdl', 'model', 'parts', 'layout', 'vision'],
    plots: ['lib', 'feed', 'model', 'layout'],
    instructor: ['lib', 'feed', 'model', 'parts', 'layout', 'map'],
    machine: ['lib', 'feed', 'bhdl', 'model', 'parts', 'layout', 'graph', 'program'],
    variables: ['lib', 'feed', 'model', 'parts', 'layout', 'map', 'plots', 'machine'],
    why: ['lib', 'feed', 'model', 'layout', 'program'],
    replay: ['lib', 'feed', 'model', 'parts', 'program'],
    timeline: ['lib', 'model', 'parts', 'layout', 'replay'],
    referee: ['lib', 'feed', 'model', 'parts', 'layout'],
    team: ['lib', 'feed', 'model', 'parts', 'layout'],
    wall: ['lib', 'model', 'parts', 'graph', 'map', 'referee', 'replay'],
    shell: ANY,
  },
};

/** The room of `path` and its top folder; undefined for what is in none, such as the generated. */
export function roomOf(path) {
  const inside = path.startsWith('web/src/') ? `web/${path.slice('web/src/'.length)}` : path;
  const [top, ...rest] = inside.split('/');
  if (!(top in rooms) || rest.length === 0 || (top === 'web' && inside === path)) return undefined;
  return { top, room: rest.slice(0, -1).join('/') || '.' };
}

/** Why a file of room `from` may not include one of room `to`; undefined where it may. */
export function offence(from, to) {
  if (!from || !to || from.top !== to.top || from.room === to.room) return undefined;
  const allowed = rooms[from.top][from.room];
  if (allowed === undefined) return `${from.top}/${from.room} is a room that rooms.mjs does not know`;
  if (allowed === ANY || allowed.includes(to.room)) return undefined;
  return `${from.top}/${from.room} may not include ${from.top}/${to.room}`;
}

/** A way in a circle through the rooms of `top`, as a list of them; undefined where there is none. */
export function circle(top) {
  const done = new Set();
  const walk = (room, way) => {
    if (way.includes(room)) return [...way.slice(way.indexOf(room)), room];
    if (done.has(room)) return undefined;
    const below = rooms[top][room];
    for (const next of below === ANY ? [] : below) {
      const found = walk(next, [...way, room]);
      if (found) return found;
    }
    done.add(room);
    return undefined;
  };
  return Object.keys(rooms[top]).map((room) => walk(room, [])).find(Boolean);
}
