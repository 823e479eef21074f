// SPDX-License-Identifier: MIT
// What the page tells its visitor: errors in a box, news to screen readers, progress in a bar.
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

/** Shows an error where one looks, or takes it away. A cancelled run is none.
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
  if (hint) box.append(element('span', original ? { lang: 'en' } : {}, hint));
  box.scrollIntoView({ block: 'nearest' });
}

/** Good news in a box of its own; empty to take it away. @param {string} text */
export function showNews(text) {
  const box = byId('news', HTMLElement);
  box.textContent = text;
  box.hidden = !text;
  if (text) announce(text);
}

/** @param {{ phase: string, fraction: number } | null} event null: nothing runs
 * @param {number | null} [left] milliseconds, if that is known */
export function showProgress(event, left = null) {
  byId('progress', HTMLElement).hidden = !event;
  if (!event) return;
  byId('progress-phase', HTMLElement).textContent = event.phase;
  const done = number(event.fraction, { style: 'percent' });
  byId('progress-percent', HTMLElement).textContent = left === null ? done
    : `${done} · ${t('progress.left', { seconds: count(Math.ceil(left / 1000)) })}`;
  byId('progress-bar', HTMLProgressElement).value = event.fraction;
}
