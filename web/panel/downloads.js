// SPDX-License-Identifier: MIT
// Hands files to the visitor: one as it is, several (an OBJ with its materials) as one ZIP.
import { formats } from 'remesher/formats';
import { zipSync } from 'three/addons/libs/fflate.module.js';
import { element } from '../base/dom.js';
import { withExtension } from '../base/format.js';

/** @typedef {import('../model/files.js').NamedBytes} NamedBytes */

/** @param {NamedBytes[]} files @returns {NamedBytes} */
function asOne(files) {
  if (files.length === 1) return files[0];
  const entries = Object.fromEntries(files.map(({ name, bytes }) => [name, bytes]));
  return { name: withExtension(files[0].name, 'zip'), bytes: zipSync(entries, { level: 6 }) };
}

/** @param {NamedBytes[]} files */
export function download(files) {
  const { name, bytes } = asOne(files);
  const url = URL.createObjectURL(new Blob([/** @type {BlobPart} */ (bytes)]));
  element('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);  // a slow disk may still be reading it
}

/** A button a format that is one file; the first is the one most people want.
 * @param {(format: string) => void} onFormat */
export function downloadButtons(onFormat) {
  const buttons = formats.filter((format) => format !== 'gltf').map((format, i) => {
    const label = `${i ? '' : 'Download '}${format.toUpperCase()}`;
    const button = element('button', { type: 'button', className: i ? '' : 'primary' }, label);
    button.addEventListener('click', () => onFormat(format));
    return button;
  });
  return element('div', { className: 'downloads', role: 'group', 'aria-label': 'Download' },
    ...buttons);
}
