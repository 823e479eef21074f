// SPDX-License-Identifier: MIT
// Hands files to the visitor.
import { element } from '../base/dom.js';

/** @param {import('../files/files.js').NamedBytes} file */
export function download({ name, bytes }) {
  const url = URL.createObjectURL(new Blob([/** @type {BlobPart} */ (bytes)]));
  element('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);  // a slow disk may still be reading it
}
