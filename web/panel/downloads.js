// SPDX-License-Identifier: MIT
// Hands files to the visitor.
import { formats } from 'remesher/formats';
import { element } from '../base/dom.js';
import { t } from '../base/i18n.js';

/** @param {import('../model/files.js').NamedBytes} file */
export function download({ name, bytes }) {
  const url = URL.createObjectURL(new Blob([/** @type {BlobPart} */ (bytes)]));
  element('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);  // a slow disk may still be reading it
}

/** A button a format that is one file; the first is the one most people want.
 * @param {(format: string) => void} onFormat */
export function downloadButtons(onFormat) {
  const buttons = formats.filter((format) => format !== 'gltf').map((format, i) => {
    const label = i ? format.toUpperCase()
      : t('download.first', { format: format.toUpperCase() });
    const button = element('button', { type: 'button', className: i ? '' : 'primary' }, label);
    button.addEventListener('click', () => onFormat(format));
    return button;
  });
  return element('div', { className: 'downloads', role: 'group', 'aria-label': t('download') },
    ...buttons);
}
