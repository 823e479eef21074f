// SPDX-License-Identifier: MIT
// All that few visitors need, out of sight until it is asked for; the browser keeps whether it was.
import { byId } from '../base/dom.js';
import { switchSetting } from '../base/memory.js';

const narrow = '(max-width: 760px)';
const isShown = switchSetting('expert', 'open');

/** Opens it, and shows one of its parts. @param {string} [selector] */
export function openExpert(selector = '') {
  const expert = byId('expert', HTMLDetailsElement);
  expert.open = true;
  const part = selector ? expert.querySelector(selector) : expert;
  part?.scrollIntoView({ block: 'start' });
}

export function wireExpert() {
  const expert = byId('expert', HTMLDetailsElement);
  const isSheet = () => matchMedia(narrow).matches;  // which would cover the page
  expert.open = isShown.recall() !== undefined && !isSheet();
  expert.addEventListener('toggle', () => {
    if (!isSheet()) isShown.remember(expert.open ? 'open' : null);
  });
  byId('other-formats', HTMLButtonElement).addEventListener('click', () =>
    openExpert('.takeaway'));
}
