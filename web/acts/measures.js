// SPDX-License-Identifier: MIT
// The model's size and unit: shown, chosen, and given to the purposes.
import { isWorthBaking } from 'remesher/options';
import { byId, element } from '../base/dom.js';
import { length } from '../base/format.js';
import { t } from '../base/i18n.js';
import { treeOf } from '../files/glb.js';
import { exactFrom } from '../model/purposes.js';
import { keepUnit, knownUnit, saidUnit, units } from '../model/units.js';

/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('../model/units.js').Unit} Unit */

/** The option `units`, where the visitor has said the unit: a 3MF that is written states it.
 * @param {Page} page @returns {{ units?: Exclude<Unit, 'none'> }} */
export function unitOption({ session: { model, isGltf } }) {
  const unit = model && !isGltf ? saidUnit(model) : undefined;
  return unit && unit !== 'none' ? { units: unit } : {};
}

/** The tree of a glTF file; undefined if it cannot be read: the reader says why.
 * @param {Uint8Array} bytes */
function treeIn(bytes) {
  try {
    return treeOf(bytes);
  } catch {
    return undefined;
  }
}

/** Gives the purposes the facts that their numbers come from. @param {Page} page */
export function tellPanel(page) {
  const { session: { model, inspection, isGltf }, surveying, stage, panel } = page;
  const { name, size } = page.surveying.scale;
  const isTextured = stage.viewer?.isTextured ?? true;
  const { triangles = 0 } = inspection?.input ?? {};
  const tree = isGltf && model ? treeIn(model.bytes) : undefined;
  const isBaked = (/** @type {number} */ faces) =>
    tree !== undefined && isWorthBaking(tree, Math.round(faces));
  const exact = exactFrom(surveying.corners, triangles);
  panel.setSubject({ triangles, diagonal: surveying.diagonal, unit: size, exact, isBaked,
    isPaintable: isGltf || isTextured },
  { ofAmount: name || t('unit.some'), ofModel: isGltf ? 'm' : name });
}

/** Shows how large the model is, with a choice of the unit where the format has none.
 * @param {Page} page @param {() => void} onUnit */
export function showSize(page, onUnit) {
  const { session, surveying: { extent } } = page;
  const { model } = session;
  const line = byId('model-size', HTMLElement);
  line.hidden = !model || !extent;
  if (!model || !extent) return;
  const { name, size } = page.surveying.scale;
  const sides = extent.toArray().map((side) => length(side / size)).join(' × ');
  const menu = element('select', { id: 'unit', ariaLabel: t('unit') },
    ...[...new Set([...units, name || 'none'])].map((unit) => element('option', { value: unit },
      unit === 'none' ? t('unit.none') : unit)));
  menu.value = name || 'none';
  menu.addEventListener('change', () => {
    keepUnit(model, /** @type {Unit} */ (menu.value));
    showSize(page, onUnit);
    onUnit();
  });
  const isAssumed = name !== '' && !session.isGltf && !knownUnit(session);
  line.replaceChildren(`${sides} `, session.isGltf ? name : menu, ...(isAssumed
    ? [element('small', { className: 'quiet' }, t('unit.assumed'))] : []));
  tellPanel(page);
}
