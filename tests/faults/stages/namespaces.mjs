// SPDX-License-Identifier: BSD-3-Clause
// Disks and networks of a test's own, in namespaces of Linux: as root, or in a namespace of users.
import { spawn, spawnSync } from 'node:child_process';
import { PATIENCE_MS } from '../../tools/patience.mjs';
import { until } from '../table.mjs';
import { closeOf, endChild } from './children.mjs';

const asRoot = () => (process.getuid() === 0 ? [] : ['--user', '--map-root-user']);

// In a chroot no namespace can make the mounts that it begins with its own. There a folder is first made a mount.
const canOwnMounts = spawnSync('unshare', [...asRoot(), '--mount', 'true'], { timeout: PATIENCE_MS }).status === 0;
const SHARES_MOUNTS = ['--propagation', 'unchanged'];
const OWN_MOUNT = 'mount --bind "$0" "$0" && mount --make-private "$0" && ';

/** The command that runs `command` with a disk of so many kB on `folder`, in the same process. */
export const onSmallDisk = (folder, size_kB, command) =>
  ['unshare', ...asRoot(), '--mount', ...(canOwnMounts ? [] : SHARES_MOUNTS), 'bash', '-c',
    `${canOwnMounts ? '' : OWN_MOUNT}mount -t tmpfs -o size=${size_kB}k,mode=0700 tmpfs "$0" && exec "$@"`, folder, ...command];

/** Why no such disk can be made; undefined where it can. */
export function noSmallDisk() {
  const [command, ...args] = onSmallDisk('/tmp', 100, ['true']);
  return spawnSync(command, args, { timeout: PATIENCE_MS }).status === 0 ? undefined : 'no small disk can be made: it needs unshare, mount, and root or namespaces of users';
}

/** Why no network of a test's own can be made. */
export const NO_NETWORK = 'no network can be made: it needs unshare, nsenter, ip, nft, and root or namespaces of users';

/** Makes a chain of rules for what the loopback hears, and says so. */
const MAKE_NETWORK = `ip link set lo up multicast on && nft add table ip faults &&
  nft add chain ip faults heard '{ type filter hook input priority 0; }' && echo ready; exec cat`;

/** A network in which only this stage's programs are, whose packets can be lost. Undefined where none can be made. */
export async function ownNetwork(scope) {
  const holder = spawn('unshare', [...asRoot(), '--net', 'bash', '-c', MAKE_NETWORK], { stdio: ['pipe', 'pipe', 'ignore'] });
  let text = '', ended = false;
  holder.stdout.on('data', (data) => { text += data; });
  const closed = closeOf(holder).then(() => { ended = true; });
  holder.stdin.on('error', () => {});
  scope.after(() => endChild(holder, closed, () => holder.stdin.end()));
  holder.stdin.write('made\n'); // which cat says, once there are rules or there could be none
  await until(() => ended || text.includes('made'), 'a network of its own');
  if (ended || !text.includes('ready')) return undefined;
  const user = asRoot().length > 0 ? [`--user=/proc/${holder.pid}/ns/user`, '--preserve-credentials'] : [];
  const within = ['nsenter', ...user, `--net=/proc/${holder.pid}/ns/net`, '--'];
  const nft = (...words) => spawnSync(within[0], [...within.slice(1), 'nft', ...words], { encoding: 'utf8', timeout: PATIENCE_MS });
  const rule = (...words) => {
    const { status, stderr } = nft(...words);
    if (status !== 0) throw new Error(`nft ${words.join(' ')}: ${stderr}`);
  };
  const drop = (...when) => ['add', 'rule', 'ip', 'faults', 'heard', 'ip', 'protocol', 'udp', ...when, 'drop'];
  const sometimes = (percent) => drop('numgen', 'random', 'mod', '100', '<', String(percent));
  const network = {
    /** What stands before a command that is run in it. */
    within,
    /** Cuts all off from one another, by losing each packet of DDS. */
    cut: () => rule(...drop()),
    /** Loses so many of a hundred packets of DDS. Requires: losesSome. */
    lose: (percent) => rule(...sometimes(percent)),
    mend: () => rule('flush', 'chain', 'ip', 'faults', 'heard'),
    /** Whether this kernel can lose some packets and let others pass. */
    losesSome: nft(...sometimes(1)).status === 0,
  };
  network.mend();
  return network;
}
