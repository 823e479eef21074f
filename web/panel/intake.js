// SPDX-License-Identifier: MIT
// The ways a model comes in: dropped anywhere, picked from the disk, or chosen among the samples.
import { byId, element } from '../base/dom.js';
import { droppedFiles, pickedFiles } from '../model/files.js';
import { samples } from '../model/samples.js';

/** @typedef {import('../model/files.js').PathedFile} PathedFile */
/** @typedef {(items: Promise<PathedFile[]>, sample: string | null) => void} OnFiles */

/** @param {OnFiles} onFiles */
function wireDrop(onFiles) {
  const { classList } = document.body;
  let depth = 0;  // dragenter and dragleave come for every element on the way
  /** @param {DragEvent} event */
  const holdsFiles = ({ dataTransfer }) => dataTransfer?.types.includes('Files');
  addEventListener('dragenter', (event) => {
    if (!holdsFiles(event)) return;
    depth += 1;
    classList.add('dragging');
  });
  addEventListener('dragleave', () => {
    depth = Math.max(0, depth - 1);
    if (!depth) classList.remove('dragging');
  });
  addEventListener('dragover', (event) => {
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'copy';
  });
  addEventListener('drop', (event) => {
    event.preventDefault();
    depth = 0;
    classList.remove('dragging');
    if (event.dataTransfer?.files.length) onFiles(droppedFiles(event.dataTransfer), null);
  });
}

/** @param {OnFiles} onFiles */
function wireOpen(onFiles) {
  const input = byId('file-input', HTMLInputElement);
  byId('open', HTMLButtonElement).addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    if (input.files?.length) onFiles(Promise.resolve(pickedFiles(input.files)), null);
    input.value = '';  // so that the same file can be picked again
  });
  addEventListener('keydown', ({ key, target, ctrlKey, metaKey, altKey }) => {
    const isTyping = target instanceof Element && target.matches('input:not([type=range]), select');
    if (key === 'o' && !isTyping && !ctrlKey && !metaKey && !altKey) input.click();
  });
}

/** @param {string} id @returns {Promise<PathedFile[]>} */
async function sampleFiles(id) {
  const { file } = samples.find((sample) => sample.id === id) ?? samples[0];
  const response = await fetch(`./samples/${file}`);
  if (!response.ok) throw new Error(`${file} cannot be loaded: status ${response.status}.`);
  return [{ path: file, file: new File([await response.blob()], file) }];
}

/** @param {OnFiles} onFiles */
function wireSamples(onFiles) {
  const menu = byId('samples', HTMLSelectElement);
  menu.append(element('option', { value: '', disabled: true, hidden: true }, 'Samples'));
  for (const { id, title } of samples) menu.append(element('option', { value: id }, title));
  const open = (/** @type {string} */ id) => {
    menu.value = samples.some((sample) => sample.id === id) ? id : samples[0].id;
    onFiles(sampleFiles(menu.value), menu.value);
  };
  menu.addEventListener('change', () => open(menu.value));
  return { open, clear: () => { menu.value = ''; } };
}

/** @param {OnFiles} onFiles */
export function wireIntake(onFiles) {
  wireDrop(onFiles);
  wireOpen(onFiles);
  return wireSamples(onFiles);
}
