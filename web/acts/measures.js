// SPDX-License-Identifier: MIT
// The model's size and unit: shown, chosen, and given to the purposes.
import { byId, element } from '../base/dom.js';
import { length } from '../base/format.js';
import { t } from '../base/i18n.js';
import { hasManySeams } from '../model/seams.js';
import { keepUnit, saidUnit, scaleOf, unitOf, units } from '../model/units.js';

/** @typedef {import('./page.js').Page} Page */
/** @typedef {import('../model/units.js').Unit} Unit */

/** How lengths of the model are said. @param {Page} page */
export function scaleIn({ session, surveying }) {
  const { model, inspection } = session;
  const unit = !model || session.isGltf ? null : unitOf(model, inspection?.unit);
  return scaleOf(unit, surveying.diagonal);
}

/** The option `units`, where the visitor has said the unit: a 3MF that is written states it.
 * @param {Page} page @returns {{ units?: Unit }} */
export function unitOption({ session: { model, isGltf } }) {
  const unit = model && !isGltf ? saidUnit(model) : undefined;
  return unit ? { units: unit } : {};
}

/** Gives the purposes what they make their numbers of. @param {Page} page */
function tellPanel(page) {
  const { session: { model, inspection, isGltf }, surveying, stage, panel } = page;
  const { name, size } = scaleIn(page);
  const isTextured = stage.viewer?.isTextured ?? true;
  const { vertices = 0, triangles = 0 } = inspection?.input ?? {};
  const isBaked = isGltf && model !== null && hasManySeams(model.bytes, vertices);
  panel.setSubject({ triangles, diagonal: surveying.diagonal, unit: size, isBaked,
    isPaintable: isGltf || isTextured }, { ofDial: name, ofModel: isGltf ? 'm' : name });
}

/** Shows how large the model is, with a choice of the unit where the format has none.
 * @param {Page} page @param {() => void} onUnit */
export function showSize(page, onUnit) {
  const { session, surveying: { extent } } = page;
  const { model } = session;
  const line = byId('model-size', HTMLElement);
  line.hidden = !model || !extent;
  if (!model || !extent) return;
  const { name, size } = scaleIn(page);
  const sides = extent.toArray().map((side) => length(side / size)).join(' × ');
  const menu = element('select', { id: 'unit', ariaLabel: t('unit') },
    ...[...new Set([...units, name])].map((unit) => element('option', { value: unit }, unit)));
  menu.value = name;
  menu.addEventListener('change', () => {
    keepUnit(model, /** @type {Unit} */ (menu.value));
    showSize(page, onUnit);
    onUnit();
  });
  line.replaceChildren(`${sides} `, session.isGltf ? name : menu);
  tellPanel(page);
}
