// SPDX-License-Identifier: BSD-3-Clause
// Simulated robots that turn on the spot without end, each a process with a serial line that can be harmed, and a monitor.
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { freshDomain, Running, scratchFolder } from '../../end_to_end/tools.mjs';
import { until } from '../table.mjs';
import { Board } from './board.mjs';
import { Monitor } from './monitor.mjs';
import { Shim } from './shim.mjs';

/** It needs the board and the camera. */
const SPIN = `input_devices: comm_port: end frame_grabber: end end
output_devices: motor_drive: end end
variables:
  shaft: name: "shaft" status: "valid" certainty: 1
  image: name: "red"
  force: name: "right" value: <1, 0> status: "valid"
end
perceptual_schemas: look: name: "look" red_variable: "red" end end
motor_schemas: move_robot: name: "spin" input_force: "right" shaft_variable: "shaft" end end
states: state: name: "spin" perceptual_schemas: "look" end motor_schemas: "spin" end end end
`;

class DrivenRobot {
  constructor(scope, place, options, { name, serial, camera }) {
    Object.assign(this, { scope, place, options, name, camera, link: join(place.cwd, `${name}.serial`) });
    this.ring = `/dev/shm${camera.replace(/^ring:/, '')}`;
    this.board = new Board(scope, serial, this.link);
  }

  start() {
    this.running = new Running(this.scope, ['robot', '--name', this.name, '--bhdl', join(this.place.cwd, 'spin.bhdl'), '--serial', this.link,
      '--camera', this.camera, '--log-level', 'warning', ...this.options], this.place);
  }

  signal(name) {
    this.running.process.kill(name);
  }
}

/**
 * Requires: `scope` outlives what is returned. With `shim`, the clocks of robots and monitor can be set. With `attended`, robots
 * are held after faults, and keep what they ran.
 */
export async function startDriven(scope, { count = 3, shim = false, attended = false } = {}) {
  const domain = freshDomain(), cwd = scratchFolder(scope), run = `faults-${process.pid}-${domain}`;
  writeFileSync(join(cwd, 'spin.bhdl'), SPIN);
  mkdirSync(join(cwd, 'state'));
  const sim = new Running(scope, ['sim', '--live', '--scenario', 'empty', '--robots', String(count), '--run', run], { domain, cwd });
  const ready = JSON.parse((await sim.line(/^\{.*"ready".*\}$/m))[0]);
  const shims = { robots: shim && new Shim(scope, cwd, 'robots'), monitor: shim && new Shim(scope, cwd, 'monitor') };
  const place = { domain, cwd, env: { XDG_STATE_HOME: join(cwd, 'state'), ...(shims.robots ? shims.robots.env : {}) } };
  const robots = ready.robots.map((each) => new DrivenRobot(scope, place, attended ? [] : ['--resume-by-itself', '--keep-nothing'], each));
  for (const robot of robots) {
    await robot.board.ready();
    robot.start();
  }
  const monitor = await Monitor.start(scope, { domain, cwd, env: shims.monitor ? shims.monitor.env : {} });
  const stage = {
    domain, cwd, robots, monitor, shims,
    names: robots.map(({ name }) => name),
    /** Until all drive, and the monitor hears them and tells no problem. */
    well: async () => {
      for (const robot of robots) await robot.board.driving();
      await monitor.hears(robots.length);
      let problems;
      await until(async () => {
        problems = (await monitor.robots()).flatMap((each) => each.problems.map((problem) => `${each.name}: ${problem}`));
        return problems.length === 0;
      }, () => `the end of problems: ${problems.join(' ')}`, 20, 20);
    },
    each: (action) => Promise.all(robots.map(action)),
    part: (order, name, part) => monitor.ask('/api/simulation/orders', { body: { order, subject: name, part, simulation: run } }),
    cameraGone: (robot) => until(() => !existsSync(robot.ring), 'the camera to be unplugged', 10, 1),
  };
  await stage.well();
  stage.ordinary = robots.map((robot) => robot.board.fastestSince(0));
  return stage;
}
