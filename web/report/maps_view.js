// SPDX-License-Identifier: MIT
// The textures that were painted for a result. The visitor can look at each, and save it.
import { byId, element } from '../base/dom.js';
import { fileSize } from '../base/format.js';
import { t, textIfAny } from '../base/i18n.js';
import { mapsOf } from '../model/maps.js';

/** @typedef {import('../model/maps.js').Map} Map */
/** @typedef {import('../files/files.js').NamedBytes} NamedBytes */

const extensions = /** @type {Record<string, string>} */ (
  { 'image/png': 'png', 'image/jpeg': 'jpg', 'image/webp': 'webp' });

/** A map's title. @param {Map} map @param {Map[]} all */
function titleOf(map, all) {
  const title = textIfAny(`map.${map.name}`) ?? map.name;
  const alike = all.filter(({ name }) => name === map.name);
  return alike.length > 1 ? `${title} ${alike.indexOf(map) + 1}` : title;
}

/** @param {Map} map @param {string} title */
function picture({ type, bytes }, title) {
  const url = URL.createObjectURL(new Blob([/** @type {BlobPart} */ (bytes)], { type }));
  const image = element('img', { alt: title, decoding: 'async' });
  image.addEventListener('load', () => URL.revokeObjectURL(url));
  image.src = url;
  return image;
}

/** Shows a map as large as the window allows. @param {Map} map @param {string} title */
function enlarge(map, title) {
  const dialog = byId('map', HTMLDialogElement);
  const image = picture(map, title);
  const facts = byId('map-facts', HTMLElement);
  facts.textContent = '';
  image.addEventListener('load', () => {
    facts.textContent = `${image.naturalWidth} × ${image.naturalHeight} · ${fileSize(
      map.bytes.length)}`;
  });
  byId('map-title', HTMLElement).textContent = title;
  byId('map-picture', HTMLElement).replaceChildren(image);
  byId('map-close', HTMLButtonElement).onclick = () => dialog.close();
  dialog.showModal();
}

/** The maps that were painted. @param {import('../model/result.js').Result} result */
const paintedMaps = ({ values, bytes }) => (values.textures === 'bake' ? mapsOf(bytes) : []);

/** Their titles. @param {import('../model/result.js').Result} result */
export function mapTitles(result) {
  const maps = paintedMaps(result);
  return maps.map((map) => titleOf(map, maps));
}

/**
 * @param {import('../model/result.js').Result} result
 * @param {(file: NamedBytes) => void} onSave
 */
export function mapsView(result, onSave) {
  const maps = paintedMaps(result);
  if (!maps.length) return null;
  const entries = maps.map((map) => {
    const title = titleOf(map, maps);
    const extension = extensions[map.type];
    const words = title.replaceAll(' ', '-').toLowerCase();
    const file = { name: result.nameIn(extension, words), bytes: map.bytes };
    return element('li', {},
      element('button', { type: 'button', className: 'map', 'aria-label':
        t('maps.enlarge', { title }), onclick: () => enlarge(map, title) }, picture(map, '')),
      element('span', {}, title, element('span', { className: 'quiet' },
        `${extension.toUpperCase()} · ${fileSize(map.bytes.length)}`)),
      element('button', { type: 'button', className: 'link', 'aria-label':
        t('maps.save', { title }), onclick: () => onSave(file) }, t('save')));
  });
  return element('section', { className: 'maps', 'aria-label': t('maps') },
    element('h2', {}, t('maps')), element('ul', {}, ...entries));
}
