// SPDX-License-Identifier: MIT
// Messages to the visitor: errors and news in boxes, announcements to screen readers, and progress
// in a bar.
import { byId, element } from '../base/dom.js';
import { count, number } from '../base/format.js';
import { t } from '../base/i18n.js';
import { saidAs } from '../base/said.js';

/** @param {string} text heard by screen readers, not seen */
export function announce(text) {
  byId('status', HTMLElement).textContent = text;
}

export const isAbort = (/** @type {unknown} */ error) =>
  error instanceof Error && error.name === 'AbortError'
  || error instanceof DOMException && error.name === 'AbortError';

/** Shows an error and scrolls to it, or hides the box. A cancelled run is no error.
 * @param {unknown} [error] */
export function showError(error) {
  const box = byId('error', HTMLElement);
  box.replaceChildren();
  box.hidden = !error || isAbort(error);
  if (box.hidden) return;
  const { code, message, hint } =
    /** @type {{ code?: string, message?: string, hint?: string }} */ (error);
  const { text, original } = saidAs('fault', code, message || t('error.unknown'));
  box.append(element('strong', {}, text));
  if (original) box.append(element('small', { lang: 'en' }, original));
  if (hint) box.append(original ? element('small', { lang: 'en' }, hint)
    : element('span', {}, hint));
  box.scrollIntoView({ block: 'nearest' });
}

/** Shows good news in a separate box; an empty text hides the box. @param {string} text */
export function showNews(text) {
  const box = byId('news', HTMLElement);
  box.textContent = text;
  box.hidden = !text;
  if (text) announce(text);
}

/** @param {{ phase: string, fraction: number | null } | null} event null: nothing runs; its
 *   fraction: null if nobody knows how far the work is
 * @param {number | null} [left] milliseconds left, null: unknown */
export function showProgress(event, left = null) {
  byId('progress', HTMLElement).hidden = !event;
  if (!event) return;
  byId('progress-phase', HTMLElement).textContent = event.phase;
  const bar = byId('progress-bar', HTMLProgressElement);
  if (event.fraction === null || event.fraction >= 1) {  // nobody knows how long the end takes
    byId('progress-percent', HTMLElement).textContent = '';
    bar.removeAttribute('value');
    return;
  }
  const done = number(event.fraction, { style: 'percent' });
  byId('progress-percent', HTMLElement).textContent = left === null ? done
    : `${done} · ${t('progress.left', { seconds: count(Math.ceil(left / 1000)) })}`;
  bar.value = event.fraction;
}
