// SPDX-License-Identifier: MIT
// Programs of the benchmark that need CGAL, compiled where it is on the machine.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const folders = (name) => (process.env[name] ?? '').split(delimiter).filter(Boolean);

const headers = [...folders('REMESHER_INCLUDE'), '/usr/include', '/usr/local/include'];
/** @type {Map<string, string | null>} */
const programs = new Map();

function compiled(source) {
  if (!headers.some((folder) => existsSync(join(folder, 'CGAL/Surface_mesh.h')))) return null;
  const folder = mkdtempSync(join(tmpdir(), 'remesher-cgal-'));
  process.on('exit', () => rmSync(folder, { recursive: true }));
  const program = join(folder, 'program');
  try {
    execFileSync('c++', ['-O3', '-DNDEBUG', '-std=c++17',
      ...folders('REMESHER_INCLUDE').flatMap((where) => ['-I', where]),
      fileURLToPath(new URL(source, import.meta.url)), '-o', program, '-lgmp', '-lmpfr'],
    { stdio: 'ignore' });
    return program;
  } catch {
    return null; // its libraries are missing
  }
}

/** The path of the program, compiled when it is first asked for; null without CGAL.
 * @param {string} source its name in this folder */
export function cgalProgram(source) {
  if (!programs.has(source)) programs.set(source, compiled(source));
  return programs.get(source);
}
