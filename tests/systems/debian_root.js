// SPDX-License-Identifier: MIT
// A Debian of any suite in a folder, as fresh as debootstrap makes it. What runs in it has its own
// mounts and its own processes (unshare), which end with it and with this program: however that is,
// nothing stays mounted, and nothing of the computer’s own is reached when the folder is deleted.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { createWriteStream, existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync }
  from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';

import { nodePackage } from '../nodes/binaries.js';
import { root as checkout } from '../support/tree.js';
import { copyNetworkSettings, debianMirror, networkVariables } from './machine.js';

const alone = ['--pdeathsig', 'KILL', 'unshare', '--mount', '--pid', '--fork', '--kill-child'];
/** The shell that mounts what programs expect, and becomes the program. */
const inside = 'mount --rbind /dev "$0/dev" && mount -t proc proc "$0/proc" '
  + '&& mount -t sysfs sys "$0/sys" && exec chroot "$0" "$@"';
/** What the README wants, and what fetches and checks a clone. */
const oldestNode = 20;
const first = ['ca-certificates', 'git'];

export class DebianRoot {
  /** @type {import('node:child_process').ChildProcess | undefined} */
  #running;
  #isOver = false;
  #log;
  #folder;
  /** Where the clone is, as the system itself sees it. */
  clone = '/srv/remesher';

  /** @param {string} suite @param {string} log a file for all that is printed */
  constructor(suite, log) {
    this.suite = suite;
    mkdirSync(dirname(log), { recursive: true });
    this.#log = createWriteStream(log);
    this.#folder = mkdtempSync(join(tmpdir(), `remesher-${suite}-`));
  }

  /**
   * @param {readonly string[]} words a command of this computer
   * @param {(text: string) => void} [onText] hears what it prints
   * @returns {Promise<string>} all that it printed
   */
  #run(words, onText = () => {}) {
    if (this.#isOver) return Promise.reject(new Error('interrupted'));
    return new Promise((resolve, reject) => {
      this.#log.write(`\n$ ${words.join(' ')}\n`);
      const child = spawn('setpriv', [...alone, ...words],
        { env: this.#environment(), stdio: ['ignore', 'pipe', 'pipe'] });
      this.#running = child;
      let printed = '';
      for (const stream of [child.stdout, child.stderr]) {
        stream.setEncoding('utf8').on('data', (text) => {
          printed += text;
          this.#log.write(text);
          onText(text);
        });
      }
      child.on('error', reject);
      child.on('close', (status, signal) => {
        this.#running = undefined;
        if (status === 0) resolve(printed);
        else reject(Object.assign(new Error(`${words.at(-1)} ended with ${signal ?? status}`),
          { printed }));
      });
    });
  }

  #environment() {
    return { PATH: '/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin', HOME: '/root',
      LANG: 'C.UTF-8', DEBIAN_FRONTEND: 'noninteractive', ...networkVariables() };
  }

  /**
   * A command of the system's shell, in the clone once there is one.
   * @param {string} command
   * @param {(text: string) => void} [onText]
   */
  run(command, onText) {
    return this.#run(['sh', '-c', inside, this.#folder, 'sh', '-c',
      `cd ${this.clone} 2>/dev/null; ${command}`], onText);
  }

  /** The system with git, and with Node as the README wants it. @returns where Node is from */
  async make() {
    const mirror = debianMirror();
    await this.#run(['debootstrap', '--variant=minbase', this.suite, this.#folder,
      ...(mirror ? [mirror] : [])]);
    copyNetworkSettings(this.#folder);
    // A system that goes away need not outlive a power cut: two thousand files are not waited for.
    writeFileSync(join(this.#folder, 'etc/dpkg/dpkg.cfg.d/90fast'), 'force-unsafe-io\n');
    const install = 'apt-get install -y -qq --no-install-recommends';
    await this.run(`apt-get update -qq && ${install} ${first.join(' ')}`);
    const policy = await this.run('apt-cache policy nodejs');
    const [, archived = '0'] = /Candidate: (\d+)/.exec(policy) ?? [];
    if (Number(archived) >= oldestNode) {
      await this.run(`${install} nodejs npm`);
      return `its archive's Node ${archived}`;
    }
    const packages = [`${nodePackage}@${oldestNode}`, 'npm@10'];
    const { status, stderr } = spawnSync('npm', ['install', '--global', '--no-audit', '--no-fund',
      '--prefix', join(this.#folder, 'usr/local'), ...packages], { encoding: 'utf8' });
    if (status !== 0) throw new Error(`npm cannot install ${packages.join(' ')}: ${stderr}`);
    return `the npm packages ${packages.join(' and ')} (its archive has Node ${archived})`;
  }

  /** Puts a commit of this checkout there, whichever branch it is of. @param {string} commit */
  takeClone(commit) {
    const place = join(this.#folder, this.clone);
    const git = (/** @type {string[]} */ ...words) => {
      const { status, stderr } = spawnSync('git', words, { encoding: 'utf8' });
      if (status !== 0) throw new Error(`git ${words.join(' ')}: ${stderr}`);
    };
    git('init', '--quiet', place);
    git('-C', checkout, 'push', '--quiet', place, `${commit}:refs/heads/tried`);
    git('-C', place, 'checkout', '--quiet', 'tried');
  }

  /** Ends what runs in it, with all its processes. */
  async stop() {
    const child = this.#running;
    if (!child) return;
    child.kill('SIGKILL');
    await once(child, 'close');
  }

  /** Nothing runs in it from now on. */
  interrupt() {
    this.#isOver = true;
    return this.stop();
  }

  /** @param {boolean} isKept @returns the folder, if it stays */
  async end(isKept) {
    await this.interrupt();
    this.#log.end();
    if (isKept) return this.#folder;
    if (readFileSync('/proc/self/mountinfo', 'utf8').includes(` ${this.#folder}`)) {
      throw new Error(`Something is mounted below ${this.#folder}: nothing is deleted`);
    }
    // What was killed may hold on to its folder for a moment; and rm is quicker than Node.
    for (let times = 0; times < 5 && existsSync(this.#folder); times += 1) {
      spawnSync('rm', ['-rf', '--one-file-system', this.#folder]);
    }
    return existsSync(this.#folder) ? this.#folder : undefined;
  }
}
