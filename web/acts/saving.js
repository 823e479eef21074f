// SPDX-License-Identifier: MIT
// Saves a result as files, a report or a picture, and copies texts such as its command line.
import { withExtension } from '../base/format.js';
import { t } from '../base/i18n.js';
import { packed } from '../files/archives.js';
import { download } from '../panel/downloads.js';
import { announce, showNews } from '../panel/messages.js';

/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('../files/files.js').NamedBytes} NamedBytes */

/** Number of levels of detail. */
const levelCount = 4;

/** @param {NamedBytes} file */
function save(file) {
  download(file);
  announce(t('saved', { name: file.name }));
}

/** Saves one file as it is, several files (such as an OBJ with its materials) as one ZIP.
 * @param {NamedBytes[]} files */
async function hand(files) {
  const zipName = withExtension(files[0].name, 'zip');
  download(files.length === 1 ? files[0] : await packed(zipName, files));
}

/** @param {Page} page @param {boolean} hasBackground */
async function picture({ session, stage }, hasBackground) {
  const bytes = await stage.picture({ scale: 2, hasBackground });
  const name = withExtension(session.model?.name ?? 'model', 'png');
  if (bytes) download({ name, bytes });
}

/** @param {string} text */
async function copy(text) {
  await navigator.clipboard.writeText(text);
  showNews(t('copied'));
}

/** @param {Page} page */
export function savingActs(page) {
  const { session } = page;
  return {
    onFormat: (/** @type {string} */ format) =>
      page.busy(async () => hand(await session.filesAs(format))),
    onLevels: () => page.busy(async () => hand(await session.levels(levelCount))),
    onReport: () => {
      const text = `${JSON.stringify(session.shown?.report, null, 2)}\n`;
      const name = withExtension(session.model?.name ?? 'model', 'report.json');
      save({ name, bytes: new TextEncoder().encode(text) });
    },
    onFile: save,
    onPicture: (/** @type {boolean} */ hasBackground) =>
      page.busy(() => picture(page, hasBackground)),
    onCopy: (/** @type {string} */ text) => page.busy(() => copy(text)),
  };
}
