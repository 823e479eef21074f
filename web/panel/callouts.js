// SPDX-License-Identifier: MIT
// Hints for a first visit: three short ones, one after the other, each beside its control.
// A hint goes away when it is read, or when the visitor does what it says.
import { byId, element } from '../base/dom.js';
import { switchSetting } from '../base/memory.js';
import { onLanguage, t } from '../base/i18n.js';

const isSeen = switchSetting('welcome', 'seen');

/** Where each hint stands, and what ends it. The first lies on the stage: were it among the
 * purposes, they would move from under the pointer when it goes. */
const hints = /** @type {const} */ ([
  { text: 'hint.purpose', place: 'stage', side: 'purpose', ground: 'form', event: 'click',
    what: '.door' },
  { text: 'hint.compare', place: 'stage', side: 'stage', ground: 'stage',
    event: 'pointerdown', what: '#canvas, #divider' },
  { text: 'hint.download', place: 'download-bar', side: 'download-bar', ground: 'download-bar',
    event: 'click', what: '#download' },
]);

/** @param {number} number of the hint, from 0 */
function show(number) {
  const hint = hints[number];
  if (!hint) {
    isSeen.remember('seen');
    return;
  }
  const words = element('span', {}, t(hint.text));
  const button = element('button', { type: 'button', className: 'link' });
  const box = element('div', { className: `callout ${hint.side}-callout`, id: 'callout' },
    words, button);
  const write = () => {
    words.textContent = t(hint.text);
    button.textContent = t(number + 1 < hints.length ? 'hint.next' : 'hint.done');
  };
  const ends = new AbortController();
  const end = () => {
    ends.abort();
    box.remove();
    show(number + 1);
  };
  write();
  onLanguage(() => box.isConnected && write());
  button.addEventListener('click', end);
  byId(hint.ground, HTMLElement).addEventListener(hint.event, ({ target }) => {
    if (target instanceof Element && target.closest(hint.what)) end();
  }, { signal: ends.signal });
  byId(hint.place, HTMLElement).prepend(box);
}

export function showCallouts() {
  if (isSeen.recall() === undefined) show(0);
}
