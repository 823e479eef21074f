// SPDX-License-Identifier: MIT
// Hands files to the visitor.
import { byId, element } from '../base/dom.js';

/** Whether the result can be saved: not while another one is made, and not a draft.
 * @param {boolean} isSavable */
export function setSavable(isSavable) {
  const others = byId('besides', HTMLElement).querySelectorAll('button');
  for (const button of [byId('download', HTMLButtonElement), ...others]) {
    button.disabled = !isSavable;
  }
}

/** @param {import('../files/files.js').NamedBytes} file */
export function download({ name, bytes }) {
  const url = URL.createObjectURL(new Blob([/** @type {BlobPart} */ (bytes)]));
  element('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);  // a slow disk may still be reading it
}
