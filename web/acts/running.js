// SPDX-License-Identifier: MIT
// A run is asked for, its result shown, and taken home.
import { byId, element } from '../base/dom.js';
import { count, degrees, withExtension } from '../base/format.js';
import { t } from '../base/i18n.js';
import { commandLine, writeAddress } from '../model/address.js';
import { packed } from '../model/archives.js';
import { download, downloadButtons } from '../panel/downloads.js';
import { announce } from '../panel/messages.js';
import { reportView } from '../panel/report_view.js';

/** @typedef {import('./page.js').Page} Page */

/** @param {Page} page @param {string} format */
const save = (page, format) => page.busy(async () => {
  const files = await page.session.filesAs(format);
  const [{ name }] = files;
  download(files.length === 1 ? files[0] : await packed(withExtension(name, 'zip'), files));
});

/** @param {Page} page */
function commandView({ session }) {
  const name = session.model?.name ?? '';
  const command = commandLine(name, withExtension(name, 'remeshed.glb'),
    /** @type {import('../model/address.js').Values} */ (session.options));
  return element('details', { className: 'command' },
    element('summary', {}, t('command')), element('code', {}, command));
}

/** @param {Page} page */
export function showReport(page) {
  const { result } = page.session;
  if (!result) return;
  byId('result-count', HTMLElement).textContent = count(result.report.output.vertices);
  const view = byId('result', HTMLElement);
  view.replaceChildren(...reportView(result.report),
    downloadButtons((format) => save(page, format)), commandView(page));
  view.hidden = false;
}

/** @param {Page} page */
export function clearResult({ stage }) {
  stage.clear('result');
  const view = byId('result', HTMLElement);
  view.hidden = true;
  view.replaceChildren();
  byId('result-count', HTMLElement).textContent = '';
}

/** @param {Page} page */
export async function remesh(page) {
  const { session, panel, stage } = page;
  const values = panel.values();
  history.replaceState(null, '', writeAddress(session.source, values));
  const { bytes, report } = await session.run(values);
  await stage.show('result', { bytes, resources: [] });
  showReport(page);
  const { vertices, minAngle } = report.output;
  announce(t('done', { count: count(vertices), mean: degrees(minAngle.mean),
    worst: degrees(minAngle.worst) }));
}
