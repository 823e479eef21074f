// SPDX-License-Identifier: MIT
// A folder tree with a model's folder and secrets around it, the names by which a model may try to
// reach the secrets, and models that refer to a given name.
import { execFileSync } from 'node:child_process';
import {
  closeSync, ftruncateSync, mkdirSync, mkdtempSync, openSync, readdirSync, readFileSync,
  readlinkSync, symlinkSync, writeFileSync,
} from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';

import { packGlb } from '../../bindings/package/codecs/gltf_container.js';
import { gltfParts, objText, torus } from './shape_files.js';

export const secret = 'SECRET-e3b0c442';

/** Makes top/secret.png, top/models/… and returns the top, and a function that closes the tree. */
export async function makeTree() {
  const top = mkdtempSync(join(tmpdir(), 'remesher-tree-'));
  const at = (...parts) => join(top, ...parts);
  for (const folder of ['models/inner', 'models/folder.png', 'models/.ssh', 'models-other',
    'outside', 'textures', 'out']) mkdirSync(at(folder), { recursive: true });
  for (const file of ['secret.png', 'models-other/secret.png', 'outside/secret.png',
    'models/.hidden.png', 'models/.ssh/secret.png']) writeFileSync(at(file), secret);
  writeFileSync(at('textures/wood.png'), '\x89PNG wood');
  writeFileSync(at('models/inner/own.png'), '\x89PNG own');
  symlinkSync('../secret.png', at('models/link.png'));
  symlinkSync(at('secret.png'), at('models/absolute.png'));
  symlinkSync('link.png', at('models/link-to-link.png'));
  symlinkSync('../outside', at('models/linked'));
  symlinkSync('loop.png', at('models/loop.png'));
  symlinkSync('/dev/zero', at('models/zero.png'));
  symlinkSync('/proc/self/environ', at('models/environ.png'));
  symlinkSync('inner/own.png', at('models/within.png'));
  execFileSync('mkfifo', [at('models/pipe.png')]);
  const huge = openSync(at('models/huge.png'), 'w'); // sparse
  ftruncateSync(huge, 2 ** 30 + 1);
  closeSync(huge);
  const server = createServer();
  await new Promise((resolve) => server.listen(at('models/socket.png'), resolve));
  return { top, close: () => server.close() };
}

/** All paths below a folder, with the contents of plain files. */
export function contentsOf(folder) {
  const entries = readdirSync(folder, { withFileTypes: true })
    .sort((a, b) => (a.name < b.name ? -1 : 1));
  return entries.flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return [path, ...contentsOf(path)];
    if (entry.isSymbolicLink()) return [`${path} -> ${readlinkSync(path)}`];
    return [entry.isFile() && entry.name !== 'huge.png'
      ? `${path}: ${readFileSync(path, 'latin1')}` : path];
  });
}

/** Spellings of names outside top/models, or of entries there that are no file of a model. */
export function tricksFor(top) {
  return [
    '../secret.png', './../secret.png', 'inner/../../secret.png', 'inner/./.././../secret.png',
    `../../${basename(top)}/secret.png`, '../models-other/secret.png', '../outside/secret.png',
    '../'.repeat(40) + 'etc/passwd', 'nothere/../../secret.png',
    join(top, 'secret.png'), `/${join(top, 'secret.png')}`, `//localhost${join(top, 'secret.png')}`,
    '/etc/passwd', '/dev/zero', '/dev/stdin', '/proc/self/environ', '/proc/self/fd/0',
    `file://${join(top, 'secret.png')}`, 'file:../secret.png', 'FILE:///etc/passwd',
    'http://127.0.0.1:9/secret.png', 'ftp:secret.png', 'blob:secret.png', 'node:fs',
    '..\\secret.png', '.\\..\\secret.png', 'inner\\..\\..\\secret.png', 'inner\\../..\\secret.png',
    '\\\\localhost\\share\\secret.png', '\\\\?\\C:\\secret.png', '\\etc\\passwd',
    'C:\\secret.png', 'C:/secret.png', 'C:secret.png', 'c:..\\secret.png',
    '%2e%2e%2fsecret.png', '%2E%2E%2Fsecret.png', '%2e%2e/secret.png', '..%2fsecret.png',
    '..%5csecret.png', '%2e%2e%5csecret.png', '.%2e/secret.png', 'inner/%2e%2e/%2e%2e/secret.png',
    '%2fetc%2fpasswd', 'file%3a%2f%2f%2fetc%2fpasswd', 'c%3a%5csecret.png',
    '%252e%252e%252fsecret.png', '%25252e%25252e%25252fsecret.png', '..%252fsecret.png',
    `${'%25'.repeat(12)}2e${'%25'.repeat(12)}2e/secret.png`,
    `%${'25'.repeat(20)}2e%${'25'.repeat(20)}2e%${'25'.repeat(20)}2fsecret.png`,
    '%2e%2e%2f%ff/../secret.png', '%c0%ae%c0%ae/secret.png', '%c0%ae%c0%ae%c0%afsecret.png',
    '..%00/secret.png', '../secret.png%00.png', '%00', '..%0a/secret.png',
    '../secret.png?a=1', '../secret.png#a', '..;/secret.png', '....//secret.png',
    '…/secret.png', '．．/secret.png', '..∕secret.png', '\u202egnp.terces/..',
    'link.png', 'absolute.png', 'link-to-link.png', 'linked/secret.png', 'linked/../secret.png',
    'linked', 'loop.png', 'zero.png', 'environ.png', 'pipe.png', 'socket.png', 'folder.png',
    'folder.png/', 'inner', '.', './', '..', 'huge.png', '.hidden.png', './.hidden.png',
    '.ssh/secret.png', '%2essh/secret.png', '.ssh\\secret.png', '~/.ssh/secret.png',
    '$HOME/secret.png', 'CON', 'nul.png', 'inner/COM1', '*.png', `${'a'.repeat(5000)}.png`,
  ];
}

const shape = torus(4, 3);

/** A glTF with an embedded buffer, and with `more` in its JSON. */
function gltfTree(more) {
  const { json, buffer } = gltfParts(shape);
  json.buffers[0].uri = `data:application/octet-stream;base64,${buffer.toString('base64')}`;
  return { ...json, ...more };
}

const bytesOf = (text) => new TextEncoder().encode(text);

/** An OBJ with a material library beside it, whose texture has the given name. */
export const modelWithLibrary = {
  'library.obj': bytesOf(`mtllib beside.mtl\n${objText(shape)}`),
  'beside.mtl': (name) => bytesOf(`newmtl red\nmap_Kd ${name}\n`),
};

/** For each way to name a file: the bytes of a model that names it so. */
export const carriers = {
  'library.obj': (name) => bytesOf(`mtllib ${name}\n${objText(shape)}`),
  'image.gltf': (name) => bytesOf(JSON.stringify(gltfTree({ images: [{ uri: name }] }))),
  'buffer.gltf': (name) => {
    const { json } = gltfParts(shape);
    return bytesOf(JSON.stringify({ ...json, buffers: [{ ...json.buffers[0], uri: name }] }));
  },
  'image.glb': (name) => {
    const { json, buffer } = gltfParts(shape);
    return packGlb({ ...json, images: [{ uri: name }] }, buffer);
  },
  'buffer.glb': (name) => {
    const { json, buffer } = gltfParts(shape);
    return packGlb({ ...json, buffers: [json.buffers[0], { byteLength: 4, uri: name }] }, buffer);
  },
};
