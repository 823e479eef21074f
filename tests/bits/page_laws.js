// SPDX-License-Identifier: MIT
// What holds of the page in every browser, tried from the page around its frame.

const patience = 60_000;

/** Waits until a condition holds. @param {string} what @param {() => unknown} holds */
async function until(what, holds) {
  const end = performance.now() + patience;
  while (!holds()) {
    if (performance.now() > end) throw new Error(`waited in vain: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

const tetrahedron = `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1
f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n`;

/**
 * @param {any} window the page's
 * @returns {Promise<[string, boolean][]>} what was tried, and whether it holds
 */
export async function laws(window) {
  const { document } = window;
  const text = (/** @type {string} */ id) => document.getElementById(id).textContent;
  const settled = (/** @type {string} */ count) => until(`${count} vertices`,
    () => document.body.dataset.state === 'idle' && text('result-count') === count);
  const errors = [];
  window.addEventListener('error', (/** @type {ErrorEvent} */ { message }) => errors.push(message));
  const held = /** @type {[string, boolean][]} */ ([]);

  await settled('500');
  held.push(['a sample is remeshed to the number in the address', true]);
  const has3d = document.createElement('canvas').getContext('webgl2') !== null;
  const message = document.getElementById('stage-message');
  held.push(['where there is no 3-D the page says so', has3d === message.hidden]);

  document.getElementById('target').value = '700';
  document.getElementById('target').dispatchEvent(new window.Event('input', { bubbles: true }));
  document.querySelector('form button[type=submit]').click();
  await settled('700');
  held.push(['another number is asked for, and comes', true]);

  const dataTransfer = new window.DataTransfer();
  dataTransfer.items.add(new window.File([tetrahedron], 'mine.obj'));
  document.body.dispatchEvent(new window.DragEvent('drop', { dataTransfer, bubbles: true }));
  await until('the file', () => text('model-name') === 'mine.obj'
    && document.body.dataset.state === 'idle');
  held.push(['a file is dropped, and remeshed',
    Number(text('result-count').replace(/\D/g, '')) > 3]);

  const language = document.getElementById('language');
  language.value = 'de';
  language.dispatchEvent(new window.Event('change', { bubbles: true }));
  await until('German', () => document.documentElement.lang === 'de');
  held.push(['it speaks German', text('left-name') === 'Original'
    && text('right-name') === 'Ergebnis']);
  held.push([`nothing is thrown ${errors.join(' ')}`, errors.length === 0]);
  return held;
}
